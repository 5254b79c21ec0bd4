#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <thread>

#include "app/session/frame.h"
#include "app/session/live_drag.h"
#include "app/session/mailbox.h"
#include "app/session/motion_pass.h"

namespace wend {

/// The one thread that meshes and solves for the window. Requests go in through a mailbox; frames come out as
/// signals, which Qt queues to the receiver's thread.
class ComputeThread : public QObject {
    Q_OBJECT

  public:
    explicit ComputeThread(QObject* parent = nullptr);
    ~ComputeThread() override;

    void post(Request request) { m_mailbox.post(std::move(request)); }

  signals:
    /// Another rest mesh, or the same one again; frames after `keptUpTo` are void.
    void shapeReady(int revision, std::shared_ptr<const SimplicialMesh<2>> rest, double keptUpTo);
    void frameReady(wend::FramePtr frame);
    void progress(double time, double end);
    /// The whole motion is there; `problem` is empty, or says what could not be completed.
    void finished(double time, QString problem);
    /// The project makes no sense as it is; the last shape stays.
    void failed(QString reason);

  private:
    void loop(std::stop_token stop);
    void handle(const Request& request, std::stop_token stop);
    void setShape(const SetShape& request);
    void beginDrag(const BeginDrag& request, std::stop_token stop);
    void prepareDrag();
    std::vector<int> activeHandles() const;
    void dragTo(const DragTo& request);
    void endDrag(const EndDrag& request);
    void runPass(std::stop_token stop);
    void emitFinished();
    std::shared_ptr<ShapeFrame> makeFrame(double time, const Points<2>& pose, double pinError) const;

    Mailbox m_mailbox;
    // of the thread alone
    ShapeBuilder m_builder;
    BuiltShape m_shape;
    std::shared_ptr<const Project> m_project;
    MotionPass m_pass;
    std::optional<LiveDrag> m_live;  // made ahead of the next drag
    bool m_dragging = false;
    struct Preview {
        Points<2> pose;
        double end = 0;  // of the project that the drag makes
    };
    std::optional<Preview> m_preview;  // where the last drag ended, until its exact motion is there
    std::jthread m_thread;             // the last member: it stops before the others go
};

}  // namespace wend
