#include "app/engine/motion/shape_engine.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/engine/shape/held_border.h"
#include "app/project/design.h"
#include "app/project/edits/handle_edits.h"
#include "core/base/printable.h"
#include "core/energy/distortion.h"
#include "core/mesh/shape_size.h"
#include "core/mesh/used_vertices.h"

namespace wend {

namespace {

constexpr double kMostLaidAside = 8e6;  // vertices of all frames

/// Milliseconds since it was made or last read.
class LapTimer {
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
    m_wanted = request;
    m_project = request.inputs.project;
    m_generation = request.inputs.generation;
    m_revision = request.inputs.revision;
    m_dragging = false;
}

template <int Dim>
void ShapeEngineOf<Dim>::work(std::stop_token stop) {
    if (m_wanted)
        build(stop);
    else if (m_asked)
        answer(stop);
    else
        runPass(stop);
}

template <int Dim>
void ShapeEngineOf<Dim>::build(std::stop_token stop) {
    const Shape<Dim> shape = m_builder.build(m_wanted->inputs, stop);
    if (!shape.rest) return;  // stopped: built again unless something else is requested
    m_wanted.reset();
    const bool recalled = m_shape && shape.rest != m_shape->rest && recall(shape);
    if (!m_shape || shape.rest != m_shape->rest || shape.material != m_shape->material)
        m_shape = std::make_shared<const Shape<Dim>>(shape);
    const KeptFrames kept = m_pass.set(shape, m_project, m_track.frames());
    m_track.keep(kept);
    m_sink.shapeReady(m_revision, shape.rest, recalled ? KeptFrames{1, -1} : kept);
    if (recalled)
        for (const FramePtr& frame : m_track.frames()) m_sink.frameReady(frame);
    if (m_pass.isFinished()) tellFinished();
}

/// Caches the finished motion on a mesh change, and restores a cached one for the new mesh.
template <int Dim>
bool ShapeEngineOf<Dim>::recall(const Shape<Dim>& shape) {
    std::optional<Past> past = std::move(m_past);
    m_past.reset();
    const bool isPast = past && past->shape->rest == shape.rest;
    const double size = static_cast<double>(m_track.frames().size()) * m_shape->rest->vertexCount();
    const bool laysAside = m_pass.isSet() && m_pass.isFinished() && size < kMostLaidAside;
    if (laysAside) m_past = Past{m_shape, std::move(m_pass), std::move(m_track)};
    if (isPast) {
        m_shape = past->shape;
        m_pass = std::move(past->pass);
        m_track = std::move(past->track);
    } else {
        m_pass = MotionPass<Dim>();
        m_track = FrameTrack();
        if (!laysAside) m_past = std::move(past);
    }
    return isPast;
}

/// Returns the exact end of the motion if it is known, otherwise the shown frame. A drag right after another
/// one starts where that one ended, which the window may not have shown yet.
template <int Dim>
typename ShapeEngineOf<Dim>::Seen ShapeEngineOf<Dim>::seen(const BeginDrag& request) const {
    const bool isLast = request.time >= motionEnd(*m_project);
    if (isLast && !m_wanted && m_pass.isSet() && m_pass.isFinished())
        return {m_shape, m_pass.state().points, request.time};
    const auto frame = posed<Dim>(request.from);
    if (!frame) return {};
    const bool isCurrent = m_shape && frame->rest == m_shape->rest;  // with the newest material
    const BuiltPtr shape = isCurrent ? m_shape : frame->built;
    const bool isNewest = frame->live && frame->gesture == m_gesture;
    if (m_live && isNewest && m_led == m_gesture && frame->rest == m_held.shape->rest)
        return {shape, m_live->pose(), request.time};
    return {shape, frame->pose, request.time};
}

template <int Dim>
void ShapeEngineOf<Dim>::beginDrag(const BeginDrag& request) try {
    Seen from = seen(request);
    if (!from.shape || request.revision != m_revision) return;
    m_held = std::move(from);
    m_gesture = request.gesture;
    m_refusal = {};
    m_dragging = true;
    const std::vector<int> active = activeHandles(request.time);
    std::vector<int> dragged;
    for (std::size_t i = 0; i < active.size(); ++i)
        if (std::count(request.handles.begin(), request.handles.end(), active[i]))
            dragged.push_back(static_cast<int>(i));
    const auto held = prepareDrag(m_held.shape, m_held.time);
    m_live->begin(std::move(dragged), request.grip, m_held.pose, held, request.time);
    m_led = m_gesture;
} catch (const InputError& error) {
    m_refusal = messageOf(error);
    m_live.reset();
}

template <int Dim>
const std::vector<Pin>& ShapeEngineOf<Dim>::handles() const {
    return designOf(*m_project).handles;
}

template <int Dim>
std::vector<int> ShapeEngineOf<Dim>::activeHandles(double time) const {
    std::vector<int> active;
    for (int h = 0; h < static_cast<int>(handles().size()); ++h)
        if (isActive(handles()[h], time)) active.push_back(h);
    return active;
}

/// Returns the handles that hold, in the order of the drag.
template <int Dim>
std::vector<Handle<Dim>> ShapeEngineOf<Dim>::prepareDrag(const BuiltPtr& shape, double time) {
    const std::vector<Handle<Dim>> all = heldHandles<Dim>(*m_project, *shape);
    std::vector<Handle<Dim>> own;
    for (const int h : activeHandles(time)) own.push_back(all[h]);
    own.insert(own.end(), all.begin() + static_cast<std::ptrdiff_t>(handles().size()), all.end());
    if (m_live && m_live->fits(*shape, own)) return own;
    m_live.emplace(*shape, own, bodyOf(shape));
    m_led = 0;
    return own;
}

/// Prepares the next drag. Errors are reported when it starts.
template <int Dim>
void ShapeEngineOf<Dim>::readyDrag() try {
    prepareDrag(m_shape, motionEnd(*m_project));
} catch (const InputError&) {
    m_live.reset();
}

/// Reuses the body for other handles, other active handles and other materials, unless these are of the kind
/// that has another body: see CoarseBody::of().
template <int Dim>
std::shared_ptr<const CoarseBody<Dim>> ShapeEngineOf<Dim>::bodyOf(const BuiltPtr& shape) {
    const auto isElastic = [](const Shape<Dim>& one) { return std::isinf(one.material->memory); };
    if (!m_bodyOf || m_bodyOf->rest != shape->rest || isElastic(*m_bodyOf) != isElastic(*shape))
        m_body = CoarseBody<Dim>::of(*shape);
    else if (m_body && m_bodyOf->material != shape->material)
        m_body = m_body->with(*shape->material);
    m_bodyOf = shape;
    return m_body;
}

/// Errors, such as a pin inside a held part, end this drag only.
template <int Dim>
void ShapeEngineOf<Dim>::dragTo(const DragTo& request) {
    if (!m_dragging) return;
    LapTimer clock;
    typename LiveDrag<Dim>::Step step;
    try {
        if (m_live) step = m_live->follow(request.amount, request.time);
    } catch (const InputError& error) {
        m_refusal = messageOf(error);
        m_live.reset();
    }
    if (!m_live) step = {Amount::Zero(), true, m_refusal};
    const auto frame =
        makeFrame(m_held.shape, m_held.time, m_live ? m_live->pose() : m_held.pose, step.pinError);
    frame->live = true;
    frame->gesture = m_gesture;
    frame->sample = request.sample;
    frame->amount = step.amount;
    frame->stopped = step.stopped;
    frame->message = step.message;
    frame->milliseconds = clock.lap();
    m_sink.frameReady(frame);
}

template <int Dim>
void ShapeEngineOf<Dim>::runPass(std::stop_token stop) {
    typename MotionPass<Dim>::Sink sink;
    LapTimer clock;
    sink.onFrame = [&](const State<Dim>& state, double pinError) {
        const auto frame = makeFrame(m_shape, state.time, state.points, pinError);
        frame->milliseconds = clock.lap();
        m_track.add(frame);
        m_sink.frameReady(frame);
    };
    sink.onKnown = [&](const PosedPtr<Dim>& frame) {
        m_track.add(frame);
        m_sink.frameReady(frame);
    };
    sink.progress = m_sink.progress;
    sink.within = m_sink.within;
    sink.meanwhile = [this] { readyDrag(); };
    m_pass.run(sink, stop);
    if (!m_pass.isFinished()) return;
    tellFinished();
    if (!stop.stop_requested()) readyDrag();
}

/// Errors are ignored here; the motion reports them.
template <int Dim>
void ShapeEngineOf<Dim>::answer(std::stop_token stop) {
    const AskField question = *m_asked;
    const auto frame = posed<Dim>(question.frame);
    const bool isCurrent =
        frame && question.revision == m_revision && m_shape && frame->rest == m_shape->rest && m_pass.isSet();
    Points<Dim> field;
    try {
        if (isCurrent)
            field = question.influenceOf.empty()
                        ? m_pass.velocity(frame->time, frame->pose, stop)
                        : m_pass.influence(question.influenceOf, frame->time, frame->pose, stop);
    } catch (const std::exception&) {
        field.resize(Dim, 0);
    }
    if (isCurrent && field.cols() == 0 && stop.stop_requested()) return;  // again, when there is time
    m_asked.reset();
    if (isCurrent && field.cols() == frame->pose.cols())
        m_sink.fieldReady(question.number, std::make_shared<const Eigen::MatrixXd>(field));
}

template <int Dim>
void ShapeEngineOf<Dim>::giveUp() {
    m_wanted.reset();
    m_asked.reset();
    m_pass.clear();
    m_track.clear();
    m_live.reset();
    m_dragging = false;
}

template <int Dim>
void ShapeEngineOf<Dim>::tellFinished() {
    m_sink.finished(m_pass.state().time, m_pass.result().brief, m_pass.snaps());
}

template <int Dim>
std::shared_ptr<PosedFrame<Dim>> ShapeEngineOf<Dim>::makeFrame(const BuiltPtr& shape, double time,
                                                               const Points<Dim>& pose, double pinError) {
    const SimplicialMesh<Dim>& rest = *shape->rest;
    if (m_measured.rest != shape->rest)
        m_measured = {
            shape->rest, shapeSize<Dim>(rest.points, rest.cells).size, measureOf<Dim>(rest, rest.points),
            static_cast<int>(std::ranges::count(usedVertices<Dim>(rest.vertexCount(), rest.cells), true))};
    auto frame = std::make_shared<PosedFrame<Dim>>();
    frame->generation = m_generation;
    frame->time = time;
    frame->dimension = Dim;
    frame->shape = shape->rest;
    frame->vertices = rest.vertexCount();
    frame->used = m_measured.used;
    frame->cells = rest.cellCount();
    frame->diagonal = m_measured.diagonal;
    frame->built = shape;
    frame->rest = shape->rest;
    frame->material = shape->material;
    frame->pose = pose;
    frame->distortion = std::make_shared<const Distortion>(distortion<Dim>(rest, pose));
    frame->growth = measureOf<Dim>(rest, pose) / m_measured.measure;
    frame->pinError = pinError;
    return frame;
}

template class ShapeEngineOf<2>;
template class ShapeEngineOf<3>;

}  // namespace wend
