#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/engine/motion/frame.h"
#include "app/engine/motion/frame_track.h"
#include "app/engine/motion/live_drag.h"
#include "app/engine/motion/mailbox.h"
#include "app/engine/motion/motion_pass.h"
#include "core/base/message.h"

namespace wend {

/// The work of the compute thread on a project, independent of the dimension.
class ShapeEngine {
  public:
    /// Receives results, in the thread of the engine; `within` from any thread.
    struct Sink {
        std::function<void(int revision, std::shared_ptr<const void> shape, KeptFrames kept)> shapeReady;
        std::function<void(FramePtr)> frameReady;
        std::function<void(int number, VelocityPtr)> fieldReady;
        std::function<void(double time, double end)> progress, within;
        std::function<void(double time, const Message& problem, const Message& remark)> finished;
    };
    static std::unique_ptr<ShapeEngine> make(int dimension, Sink sink);
    virtual ~ShapeEngine() = default;

    virtual int dimension() const = 0;
    /// Returns whether there is nothing to compute until the next request.
    virtual bool isIdle() const = 0;
    /// Returns, for tests, whether the next drag starts without an analysis.
    virtual bool isReadyForDrag() const = 0;
    /// Sets what work() computes.
    virtual void setShape(const SetShape& request) = 0;
    /// Starts at once from the shown frame; interrupted work continues afterwards.
    virtual void beginDrag(const BeginDrag& request) = 0;
    virtual void dragTo(const DragTo& request) = 0;
    virtual void endDrag() = 0;
    /// Answered by work() before the motion continues, unless the frame belongs to another shape or motion.
    virtual void askField(const AskField& request) = 0;
    /// Computes the mesh, an answer or the motion; continues where it was stopped.
    virtual void work(std::stop_token stop) = 0;
    /// Forgets the current work after a failure or a cancellation.
    virtual void giveUp() = 0;
};

template <int Dim>
class ShapeEngineOf : public ShapeEngine {
  public:
    explicit ShapeEngineOf(Sink sink) : m_sink(std::move(sink)) {}

    int dimension() const override { return Dim; }
    bool isIdle() const override {
        return m_dragging || (!m_wanted && !m_asked && (!m_pass.isSet() || m_pass.isFinished()));
    }
    bool isReadyForDrag() const override { return m_live.has_value(); }
    void setShape(const SetShape& request) override;
    void beginDrag(const BeginDrag& request) override;
    void dragTo(const DragTo& request) override;
    void endDrag() override { m_dragging = false; }
    void askField(const AskField& request) override { m_asked = request; }
    void work(std::stop_token stop) override;
    void giveUp() override;

  private:
    const std::vector<Pin>& handles() const;
    std::vector<int> activeHandles(double time) const;
    using BuiltPtr = std::shared_ptr<const Shape<Dim>>;
    struct Seen {  // where a drag begins
        BuiltPtr shape;
        Points<Dim> pose;
        double time = 0;
    };
    Seen seen(const BeginDrag& request) const;
    std::vector<Handle<Dim>> prepareDrag(const BuiltPtr& shape, double time);
    void readyDrag();
    std::shared_ptr<const CoarseBody<Dim>> bodyOf(const BuiltPtr& shape);
    bool recall(const Shape<Dim>& shape);
    void build(std::stop_token stop);
    void runPass(std::stop_token stop);
    void answer(std::stop_token stop);
    void tellFinished();
    std::shared_ptr<PosedFrame<Dim>> makeFrame(const BuiltPtr& shape, double time, const Points<Dim>& pose,
                                               double pinError);

    Sink m_sink;
    ShapeBuilder<Dim> m_builder;
    BuiltPtr m_shape;
    std::shared_ptr<const Project> m_project;  // of m_revision; its mesh may not exist yet
    int m_generation = 0, m_revision = 0;
    std::optional<SetShape> m_wanted;  // to be built
    std::optional<AskField> m_asked;   // to be answered
    MotionPass<Dim> m_pass;
    FrameTrack m_track;  // its frames so far
    /// The last finished motion of another mesh, for undo and cancelling.
    struct Past {
        BuiltPtr shape;
        MotionPass<Dim> pass;
        FrameTrack track;
    };
    std::optional<Past> m_past;
    std::optional<LiveDrag<Dim>> m_live;            // made ahead of the next drag
    std::shared_ptr<const CoarseBody<Dim>> m_body;  // of the shape that was dragged last; null: it needs none
    BuiltPtr m_bodyOf;
    bool m_dragging = false;
    Seen m_held;        // of the current drag
    int m_gesture = 0;  // its number
    int m_led = 0;      // number of the drag that m_live follows; 0 for none
    Message m_refusal;  // why it cannot move anything
    struct Measured {   // measures of the last frame's rest mesh
        std::shared_ptr<const SimplicialMesh<Dim>> rest;
        double diagonal = 0, measure = 0;
        int used = 0;
    };
    Measured m_measured;
};

}  // namespace wend
