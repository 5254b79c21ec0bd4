#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/session/frame.h"
#include "app/session/live_drag.h"
#include "app/session/mailbox.h"
#include "app/session/motion_pass.h"

namespace wend {

/// What the compute thread does with a project, whatever its dimension.
class ShapeEngine {
  public:
    /// Where results go; called in the thread of the engine.
    struct Sink {
        std::function<void(int revision, std::shared_ptr<const void> shape, double keptUpTo)> shapeReady;
        std::function<void(FramePtr)> frameReady;
        std::function<void(double time, double end)> progress;
        std::function<void(double time, std::string problem)> finished;
        /// Stopped as soon as another request waits.
        std::function<std::stop_token()> interruption;
    };
    static std::unique_ptr<ShapeEngine> make(int dimension, Sink sink);
    virtual ~ShapeEngine() = default;

    virtual int dimension() const = 0;
    /// True if there is nothing to compute without another request.
    virtual bool isIdle() const = 0;
    virtual void setShape(const SetShape& request) = 0;
    virtual void beginDrag(const BeginDrag& request, std::stop_token stop) = 0;
    virtual void dragTo(const DragTo& request) = 0;
    virtual void endDrag(const EndDrag& request) = 0;
    virtual void runPass(std::stop_token stop) = 0;
    /// After a failure: forgets what it was doing.
    virtual void giveUp() = 0;
};

template <int Dim>
class ShapeEngineOf : public ShapeEngine {
  public:
    explicit ShapeEngineOf(Sink sink) : m_sink(std::move(sink)) {}

    int dimension() const override { return Dim; }
    bool isIdle() const override { return !m_pass.isSet() || m_pass.isFinished() || m_dragging; }
    void setShape(const SetShape& request) override;
    void beginDrag(const BeginDrag& request, std::stop_token stop) override;
    void dragTo(const DragTo& request) override;
    void endDrag(const EndDrag& request) override;
    void runPass(std::stop_token stop) override;
    void giveUp() override;

  private:
    const std::vector<Handle<Dim>>& handles() const;
    std::vector<int> activeHandles() const;
    void prepareDrag();
    void tellFinished();
    std::shared_ptr<PosedFrame<Dim>> makeFrame(double time, const Points<Dim>& pose, double pinError) const;

    Sink m_sink;
    ShapeBuilder<Dim> m_builder;
    BuiltShape<Dim> m_shape;
    double m_restMeasure = 1;
    std::shared_ptr<const Project> m_project;
    MotionPass<Dim> m_pass;
    std::optional<LiveDrag<Dim>> m_live;  // made ahead of the next drag
    bool m_dragging = false;
    struct Preview {
        Points<Dim> pose;
        double end = 0;  // of the project that the drag makes
    };
    std::optional<Preview> m_preview;  // where the last drag ended, until its exact motion is there
};

}  // namespace wend
