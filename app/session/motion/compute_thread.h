#pragma once

#include <QObject>
#include <QString>
#include <thread>

#include "app/document/hand_over.h"
#include "app/session/motion/shape_engine.h"

namespace wend {

/// The one thread that meshes and solves for the window. Requests go in through a mailbox; frames come out as
/// signals in the thread that this object lives in.
class ComputeThread : public QObject {
    Q_OBJECT

  public:
    explicit ComputeThread(QObject* parent = nullptr);
    ~ComputeThread() override;

    void post(Request request) { m_mailbox.post(std::move(request)); }

  signals:
    /// Another rest mesh, or the same one again, with what earlier frames are worth.
    void shapeReady(int revision, std::shared_ptr<const void> shape, wend::KeptFrames kept);
    void frameReady(wend::FramePtr frame);
    void fieldReady(int number, wend::VelocityPtr field);
    void progress(double time, double end);
    /// The whole motion is there; `problem` is empty, or says what could not be completed.
    void finished(double time, QString problem);
    /// The project makes no sense as it is. The last shape stays, unless `shapeless`: its surface bounds no
    /// solid.
    void failed(int revision, QString reason, bool shapeless);

  private:
    void loop(std::stop_token stop);
    void handle(const Request& request);
    void giveUp(const std::exception& error, bool shapeless);
    void requireEngine(int dimension);
    ShapeEngine::Sink sink();

    Mailbox m_mailbox;
    HandOver m_out;
    std::unique_ptr<ShapeEngine> m_engine;  // of the thread alone,
    int m_revision = 0;                     // and this: of the newest shape that was asked for
    std::jthread m_thread;                  // the last member: it stops before the others go
};

}  // namespace wend
