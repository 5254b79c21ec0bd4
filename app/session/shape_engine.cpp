#include "app/session/shape_engine.h"

#include <algorithm>
#include <chrono>

#include "app/document/handle_edits.h"

namespace wend {

namespace {

/// Milliseconds since it was made or last read.
class Stopwatch {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double, std::milli>(now - std::exchange(m_start, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

template <int Dim>
double measureOf(const SimplicialMesh<Dim>& mesh, const Points<Dim>& pose) {
    double sum = 0;
    for (const Cell<Dim>& cell : mesh.cells) sum += cellMeasure<Dim>(pose, cell);
    return sum;
}

}  // namespace

std::unique_ptr<ShapeEngine> ShapeEngine::make(int dimension, Sink sink) {
    if (dimension == 2) return std::make_unique<ShapeEngineOf<2>>(std::move(sink));
    return std::make_unique<ShapeEngineOf<3>>(std::move(sink));
}

template <int Dim>
void ShapeEngineOf<Dim>::setShape(const SetShape& request) {
    const BuiltShape<Dim> shape = m_builder.build(request.inputs, m_sink.interruption());
    if (!shape.rest) return;  // a newer request waits
    const double end = motionEnd(*request.inputs.project);
    if (m_preview && (shape.rest != m_shape.rest || end != m_preview->end)) m_preview.reset();
    m_shape = shape;
    m_restMeasure = measureOf<Dim>(*shape.rest, shape.rest->points);
    m_project = request.inputs.project;
    const double kept = m_pass.set(m_shape, m_project);
    m_sink.shapeReady(request.inputs.revision, m_shape.rest, kept);
    if (m_pass.isFinished()) tellFinished();
}

template <int Dim>
void ShapeEngineOf<Dim>::beginDrag(const BeginDrag& request, std::stop_token stop) {
    if (!m_pass.isSet()) return;
    if (!m_preview && !m_pass.isFinished()) runPass(stop);
    if (!m_preview && !m_pass.isFinished()) return;
    const std::vector<int> active = activeHandles();
    std::vector<int> dragged;
    for (std::size_t i = 0; i < active.size(); ++i)
        if (std::count(request.handles.begin(), request.handles.end(), active[i]))
            dragged.push_back(static_cast<int>(i));
    prepareDrag();
    m_live->begin(std::move(dragged), request.grip, m_preview ? m_preview->pose : m_pass.state().points);
    m_dragging = true;
}

template <int Dim>
const std::vector<Handle<Dim>>& ShapeEngineOf<Dim>::handles() const {
    return std::get<Design<Dim>>(m_project->design).handles;
}

template <int Dim>
std::vector<int> ShapeEngineOf<Dim>::activeHandles() const {
    std::vector<int> active;
    for (int h = 0; h < static_cast<int>(handles().size()); ++h)
        if (isActive(handles()[h], motionEnd(*m_project))) active.push_back(h);
    return active;
}

template <int Dim>
void ShapeEngineOf<Dim>::prepareDrag() {
    std::vector<Handle<Dim>> own;
    for (const int h : activeHandles()) own.push_back(handles()[h]);
    if (!m_live || !m_live->fits(m_shape, own)) m_live.emplace(m_shape, std::move(own));
}

template <int Dim>
void ShapeEngineOf<Dim>::dragTo(const DragTo& request) {
    if (!m_dragging) return;
    Stopwatch clock;
    const auto step = m_live->follow(request.amounts.back());
    const auto frame = makeFrame(m_pass.end(), m_live->pose(), step.pinError);
    frame->live = true;
    frame->sample = request.lastSample;
    frame->amount = step.amount;
    frame->stopped = step.stopped;
    frame->message = step.message;
    frame->milliseconds = clock.lap();
    m_sink.frameReady(frame);
}

template <int Dim>
void ShapeEngineOf<Dim>::endDrag(const EndDrag& request) {
    if (m_dragging && request.keep) m_preview = Preview{m_live->pose(), m_pass.end() + 1};
    m_dragging = false;
}

template <int Dim>
void ShapeEngineOf<Dim>::runPass(std::stop_token stop) {
    typename MotionPass<Dim>::Sink sink;
    Stopwatch clock;
    sink.onFrame = [&](const State<Dim>& state, double pinError) {
        const auto frame = makeFrame(state.time, state.points, pinError);
        frame->milliseconds = clock.lap();
        m_sink.frameReady(frame);
    };
    sink.progress = m_sink.progress;
    m_pass.run(sink, stop);
    if (!m_pass.isFinished()) return;
    m_preview.reset();
    tellFinished();
    prepareDrag();
}

template <int Dim>
void ShapeEngineOf<Dim>::giveUp() {
    m_pass.clear();
    m_live.reset();
    m_dragging = false;
}

template <int Dim>
void ShapeEngineOf<Dim>::tellFinished() {
    m_sink.finished(m_pass.state().time, m_pass.result().message);
}

template <int Dim>
std::shared_ptr<PosedFrame<Dim>> ShapeEngineOf<Dim>::makeFrame(double time, const Points<Dim>& pose,
                                                               double pinError) const {
    auto frame = std::make_shared<PosedFrame<Dim>>();
    frame->time = time;
    frame->dimension = Dim;
    frame->shape = m_shape.rest;
    frame->vertices = m_shape.rest->vertexCount();
    frame->cells = m_shape.rest->cellCount();
    frame->diagonal = boundingBoxDiagonal<Dim>(m_shape.rest->points);
    frame->rest = m_shape.rest;
    frame->facets = m_shape.facets;
    frame->material = m_shape.material;
    frame->pose = pose;
    frame->distortion = distortion<Dim>(*m_shape.rest, pose);
    frame->growth = measureOf<Dim>(*m_shape.rest, pose) / m_restMeasure;
    frame->pinError = pinError;
    return frame;
}

template class ShapeEngineOf<2>;
template class ShapeEngineOf<3>;

}  // namespace wend
