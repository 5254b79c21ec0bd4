#pragma once

#include <QObject>
#include <QString>
#include <thread>

#include "app/base/hand_over.h"
#include "app/engine/motion/shape_engine.h"

namespace wend {

/// Why a project cannot be computed: its content is invalid; its surface bounds no volume; or the machine
/// lacks the memory.
enum class ComputeFailure { Invalid, Shapeless, Memory };

/// The thread that meshes and solves for the window. Requests enter through a mailbox; frames leave as
/// signals in the thread of this object.
class ComputeThread : public QObject {
    Q_OBJECT

  public:
    explicit ComputeThread(QObject* parent = nullptr);
    ~ComputeThread() override;

    void post(Request request) { m_mailbox.post(std::move(request)); }
    /// Returns whether all requests are done and all signals about them are emitted.
    bool isIdle() const { return m_mailbox.isAwaited() && m_out.isEmpty(); }

  signals:
    /// Emitted with a rest mesh, new or unchanged, and with how much of the earlier frames remains valid.
    void shapeReady(int revision, std::shared_ptr<const void> shape, wend::KeptFrames kept);
    void frameReady(wend::FramePtr frame);
    void fieldReady(int number, wend::VelocityPtr field);
    void progress(double time, double end);
    /// Emitted with the approximate time that the current step has reached.
    void within(double time, double end);
    /// Emitted at the end of the motion; `problem` says what could not be completed, or is empty.
    void finished(double time, QString problem, QString remark);
    /// Emitted if the project cannot be computed. The last shape stays, unless the failure is Shapeless.
    void failed(int revision, QString reason, wend::ComputeFailure failure);

  private:
    void loop(std::stop_token stop);
    void handle(const Request& request);
    void giveUp(const std::exception& error, ComputeFailure failure);
    void requireEngine(int dimension);
    ShapeEngine::Sink sink();

    Mailbox m_mailbox;
    HandOver m_out;
    std::unique_ptr<ShapeEngine> m_engine;  // of the thread alone,
    int m_revision = 0;                     // and this: of the newest shape that was asked for
    std::jthread m_thread;  // last, so that the thread stops before the other members are destroyed
};

}  // namespace wend
