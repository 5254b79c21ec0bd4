#include "core/integration/drag_flow.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/integration/contradictions.h"
#include "core/integration/step_method.h"
#include "core/integration/stop_message.h"
#include "core/mesh/cell_geometry.h"

namespace wend {

namespace {

// Relative to the largest velocity. The remaining error changes direction from field to field: after a drag
// over half the size the shape is off by about a pixel in five thousand.
constexpr double kVelocityTolerance = 5e-3;
// Tolerance of a field that only predicts the midpoint.
constexpr double kGuessTolerance = 0.1;
// Seconds of a nominal machine (SolverCost): a more expensive factorization is postponed during the drag.
constexpr double kLongestPause = 0.075;
// Relative to the size: drags that start this close to the end of the last one use its fields as guesses.
constexpr double kNear = 0.05;
// Relative error of the handles above which a guess is not used for the midpoint.
constexpr double kGoodGuess = 0.1;
constexpr int kFewAttempts = 8;  // after more of them, a part that succeeds is followed by a longer one
// Largest exponent of the memory's decay in one step, and the largest number of parts of a displacement.
constexpr double kMostDrawn = 0.5, kMostParts = 4;
constexpr double kSmallestPart = 1.0 / 64;
// These are, for elastic shapes, the tolerance of the last Newton step, in sizes, and the number of
// iterations that a frame has time for. The next frame continues with what is left.
constexpr double kElasticTolerance = 1e-4;
constexpr int kMostIterations = 6;
// How often a shape is brought to rest before a handle stops, by at most so many iterations, and the part of
// the displacement that is tried next.
constexpr int kMostSettlings = 3, kMostSettlingIterations = 30;
constexpr double kSettledPart = 1.0 / 8;

/// Returns the handles, normalized and without their motions.
template <int Dim>
std::vector<Handle<Dim>> still(const std::vector<Handle<Dim>>& handles, const Normalization<Dim>& units) {
    std::vector<Handle<Dim>> result;
    for (const Handle<Dim>& handle : handles) {
        Handle<Dim> held;
        held.name = handle.name;
        held.at = handle.at;
        held.part = handle.part;
        held.slides = handle.slides;
        held.normal = handle.normal;
        if (handle.motions.empty()) held.slide = handle.slide;  // a surface that moves is not followed
        result.push_back(units.normal(held));
    }
    return result;
}

template <int Dim>
Trajectory<Dim> trajectory(const Motion<Dim>& motion, const Normalization<Dim>& units) {
    Handle<Dim> handle;
    handle.motions = {motion};
    handle.motions[0].start = 0, handle.motions[0].end = 1;
    return Trajectory<Dim>(units.normal(handle).motions[0]);
}

/// Returns the same map of points in normalized coordinates: x̂ ↦ A x̂ + (A c + b − c) / s.
template <int Dim>
AffineMap<Dim> normalized(const AffineMap<Dim>& map, const Normalization<Dim>& units) {
    return {map.A, units.normal(Vec<Dim>(map(units.centre))).eval()};
}

}  // namespace

template <int Dim>
DragFlow<Dim>::DragFlow(std::shared_ptr<const SimplicialMesh<Dim>> rest,
                        std::shared_ptr<const Material<Dim>> material,
                        const std::vector<Handle<Dim>>& handles, const BackEndFactory<Dim>& backEnd,
                        int threads)
    : m_units((requireValid<Dim>(*rest), Normalization<Dim>::of(*rest))),
      m_domainRest(std::move(rest)),
      m_rest(std::make_shared<const SimplicialMesh<Dim>>(m_units.normal(*m_domainRest))),
      m_twins(twinsOf<Dim>(*m_domainRest)),
      m_orientation(m_rest),
      m_constraints(*m_rest, still(handles, m_units), m_units),
      m_solver(m_rest, material, backEnd, threads),
      m_memory(material->memory) {
    requireValid<Dim>(*material, m_rest->cellCount());
    m_solver.setVelocityTolerance(kVelocityTolerance);
    m_solver.setLongestPause(kLongestPause);
    m_ids = m_constraints.activePoints(0, Side::After);
    const std::vector<int> sliding = m_constraints.activeSliders(0, Side::After);
    m_solver.setConstraints(rowsOf(m_constraints, m_ids), slidersOf(m_constraints, sliding));
    m_guided = guidedAlone(m_constraints, m_ids, sliding);
    m_sliders = static_cast<Eigen::Index>(sliding.size());
    m_ids.insert(m_ids.end(), sliding.begin(), sliding.end());
    begin(m_domainRest->points);
    prepare();
}

/// Factorizes at rest, near which most drags start.
template <int Dim>
void DragFlow<Dim>::prepare() {
    if (isElastic()) {
        Points<Dim> move;
        guide(m_shape);
        m_solver.predict(m_shape, Targets::Zero(Dim, m_targets.cols()), move);
        return;
    }
    const Targets all = Targets::Constant(Dim, m_targets.cols(), 1e-3);
    Points<Dim> field;
    solve(m_shape, all, field);
    m_history.clear();
}

/// Continues from a pose, which is normalized here. The fields of the history are dropped if it is far from
/// the last shape.
template <int Dim>
void DragFlow<Dim>::begin(const Points<Dim>& pose) {
    if (pose.cols() != m_rest->vertexCount()) {
        throw InputError("a pose of " + std::to_string(pose.cols()) + " vertices for a shape of " +
                         std::to_string(m_rest->vertexCount()));
    }
    m_pose = pose;
    const Points<Dim> last =
        std::exchange(m_shape, m_rest->points + (pose - m_domainRest->points) / m_units.size);
    // The first reaction is prompt: a new factor can wait for the next one.
    FactorMemory<Dim> memory = m_solver.remember();
    memory.counts.last = 0;
    m_solver.recall(memory);
    if (last.cols() != m_shape.cols() || largestColumn<Dim>(m_shape - last) > kNear) m_history.clear();
    const auto& points = m_constraints.points();
    m_targets.resize(Dim, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        m_targets.col(static_cast<Eigen::Index>(i)) = points[i].template in<Dim>(m_shape);
    m_constraintError = 0;
    m_isSettled = false;
}

/// Divides the motion into steps of a few percent of the size. A step that fails, because cells would be
/// inverted, is tried again with half its length. The step of an elastic shape that is not at rest contains
/// its way there, which does not become shorter with the displacement: before such a handle stops, the shape
/// is settled.
template <int Dim>
typename DragFlow<Dim>::Led DragFlow<Dim>::lead(const std::vector<int>& handles, const Motion<Dim>& motion,
                                                const std::vector<Alongside>& alongside) {
    const Trajectory<Dim> path = trajectory(motion, m_units);
    const Targets start = m_targets;
    Targets others = start;  // at the end
    for (const Alongside& other : alongside)
        others = moved(others, {other.handle}, normalized(other.map, m_units));
    const auto targetsAt = [&](double part) {
        const Targets along = start + part * (others - start);
        return moved(along, handles, path.at(part, Side::Before).position);
    };
    SolveOutcome failure;
    int settlings = 0;
    double done = 0, part = firstPart(targetsAt(1) - start);
    for (int attempts = 0; done < 1; ++attempts) {
        if (part < kSmallestPart) {
            if (settlings++ == kMostSettlings || !settle()) break;
            part = kSettledPart;
        }
        const double to = std::min(1.0, done + part);
        if (!step(targetsAt(to))) {
            failure = m_failure, part /= 2;
            continue;
        }
        done = to;
        if (attempts >= kFewAttempts) part *= 2;
    }
    publish();
    return done < 1 ? Led{done, describe(failure, handles)} : Led{};
}

/// Returns the targets with the points of some handles moved by a map.
template <int Dim>
typename DragFlow<Dim>::Targets DragFlow<Dim>::moved(const Targets& start, const std::vector<int>& handles,
                                                     const AffineMap<Dim>& map) const {
    Targets result = start;
    for (Eigen::Index i = 0; i < start.cols(); ++i) {
        const int handle = m_constraints.points()[static_cast<std::size_t>(i)].handle;
        if (std::find(handles.begin(), handles.end(), handle) != handles.end())
            result.col(i) = map(start.col(i));
    }
    return result;
}

/// Returns the part of the displacement that is tried first: all of it, unless the memory would draw the
/// shape back so strongly that the midpoint rule overshoots.
template <int Dim>
double DragFlow<Dim>::firstPart(const Targets& displacement) const {
    if (isElastic()) return 1;
    return 1 /
           std::clamp(std::ceil(m_memory * largestColumn<Dim>(displacement) / kMostDrawn), 1.0, kMostParts);
}

/// The prescribed velocities are the displacements of the whole step per unit of time.
template <int Dim>
bool DragFlow<Dim>::solve(const Points<Dim>& shape, const Targets& displacement, Points<Dim>& field) {
    const bool reuses = m_solver.reuses();
    guide(shape);
    m_solver.setMemoryRate(m_memory * largestColumn<Dim>(displacement));
    m_failure =
        m_solver.solve(shape, displacement, field, reuses ? m_history.fitting(displacement) : std::nullopt);
    ++m_evaluations;
    if (m_failure.done()) m_history.record(m_evaluations, displacement, field);
    return m_failure.done();
}

/// Holds points that slide on surfaces along the normals there.
template <int Dim>
void DragFlow<Dim>::guide(const Points<Dim>& shape) {
    if (!m_constraints.hasGuides()) return;
    Targets places = m_targets, velocities = m_targets;
    m_constraints.guide(m_ids, shape, 0, Side::After, places, velocities, m_directions);
    m_solver.setDirections(m_directions.rightCols(m_sliders));
}

template <int Dim>
void DragFlow<Dim>::project(Points<Dim>& shape, const Targets& targets) {
    m_solver.project(shape, targets);
    if (m_guided.empty()) return;
    m_constraints.pull(m_guided, 0, Side::After, shape);
    m_solver.project(shape, targets);
}

/// Returns whether a field moves the constrained points by the displacement, up to a small part of it.
template <int Dim>
bool DragFlow<Dim>::moves(const Points<Dim>& field, const Targets& displacement) const {
    double miss = 0;
    for (Eigen::Index i = 0; i < displacement.cols(); ++i) {
        const Vec<Dim> v = m_constraints.points()[i].template in<Dim>(field);
        Vec<Dim> off = m_constraints.deviation(static_cast<int>(i), v - displacement.col(i));
        if (m_constraints.points()[i].isGuided()) off = m_directions.col(i) * m_directions.col(i).dot(off);
        miss = std::max(miss, off.norm());
    }
    return miss <= kGoodGuess * largestColumn<Dim>(displacement);
}

template <int Dim>
bool DragFlow<Dim>::isElastic() const {
    return std::isinf(m_memory);
}

/// Moves an elastic shape to the minimum for these targets, or near it.
template <int Dim>
bool DragFlow<Dim>::track(const Targets& targets) {
    Points<Dim> next;
    guide(m_shape);
    m_failure = m_solver.predict(m_shape, targets - m_targets, next);
    ++m_evaluations;
    if (!m_failure.done()) return false;
    next += m_shape;
    project(next, targets);
    const int inverted = m_orientation.firstInverted(next);
    m_failure = {inverted < 0 ? SolveOutcome::Kind::Done : SolveOutcome::Kind::CellInverted, inverted};
    if (inverted >= 0) return false;
    if (!relax(next, targets, kMostIterations)) return false;
    m_shape = next;
    m_targets = targets;
    return true;
}

/// Moves an elastic shape towards the minimum for these targets. Returns false with m_failure if that fails.
template <int Dim>
bool DragFlow<Dim>::relax(Points<Dim>& shape, const Targets& targets, int mostIterations) {
    Descent<Dim> descent;
    descent.tolerance = kElasticTolerance;
    descent.mostIterations = mostIterations;
    descent.reusesFactor = true;
    if (m_constraints.hasGuides())
        descent.keep = [&](Points<Dim>& next) {
            project(next, targets);
            guide(next);
        };
    const Descended result = m_solver.descend(shape, descent);
    m_failure = result.outcome;
    if (m_failure.done()) m_isSettled = result.isConverged;
    return m_failure.done();
}

/// Brings an elastic shape to rest where its handles are. Returns false if it is at rest.
template <int Dim>
bool DragFlow<Dim>::settle() {
    if (!isElastic() || m_isSettled) return false;
    Points<Dim> next = m_shape;
    guide(next);
    if (!relax(next, m_targets, kMostSettlingIterations)) return false;
    m_shape = next;
    return true;
}

/// Takes one step to the targets: by the midpoint rule with the midpoint predicted from earlier fields, or
/// along the minimum for an elastic shape. The guess needs no solve while the pointer continues in a
/// direction of earlier steps; else a rough field at the start predicts the midpoint. The end is put on the
/// targets, so that errors do not add up at the handles.
template <int Dim>
bool DragFlow<Dim>::step(const Targets& targets) {
    if (isElastic()) return track(targets);
    const Targets displacement = targets - m_targets;
    if (displacement.isZero(0)) return true;
    std::optional<Points<Dim>> guess = m_history.fitting(displacement);
    if (!guess || !moves(*guess, displacement)) {
        guess.emplace();
        m_solver.setVelocityTolerance(kGuessTolerance);
        const bool done = solve(m_shape, displacement, *guess);
        m_solver.setVelocityTolerance(kVelocityTolerance);
        if (!done) return false;
    }
    Points<Dim> field;
    if (!solve(m_shape + 0.5 * *guess, displacement, field)) return false;
    Points<Dim> next = m_shape + field;
    project(next, targets);
    const int inverted = m_orientation.firstInverted(next);
    m_failure = {inverted < 0 ? SolveOutcome::Kind::Done : SolveOutcome::Kind::CellInverted, inverted};
    if (inverted >= 0) return false;
    m_shape = next;
    m_targets = targets;
    return true;
}

/// Converts the shape to a pose in the domain's coordinates, and measures how far constrained points are from
/// their targets.
template <int Dim>
void DragFlow<Dim>::publish() {
    m_pose = m_domainRest->points + m_units.size * (m_shape - m_rest->points);
    takeAlong<Dim>(m_twins, m_pose);
    m_constraintError = 0;
    for (Eigen::Index i = 0; i < m_targets.cols(); ++i) {
        if (m_constraints.points()[i].isGuided()) continue;
        const Vec<Dim> p = m_constraints.points()[i].template in<Dim>(m_shape);
        const Vec<Dim> off = m_constraints.deviation(static_cast<int>(i), p - m_targets.col(i));
        m_constraintError = std::max(m_constraintError, m_units.size * off.norm());
    }
}

/// Describes the cell that would be inverted, or else the first moved point. The cell has no number, because
/// it may belong to a coarse body that carries the shape.
template <int Dim>
Message DragFlow<Dim>::describe(const SolveOutcome& failure, const std::vector<int>& handles) const {
    Vec<Dim> place = centroid<Dim>(m_pose, m_rest->cells[std::max(failure.cell, 0)]);
    const auto isLed = [&](const ConstrainedPoint& point) {
        return std::find(handles.begin(), handles.end(), point.handle) != handles.end();
    };
    const auto& points = m_constraints.points();
    const auto led = std::find_if(points.begin(), points.end(), isLed);
    if (failure.kind != SolveOutcome::Kind::CellInverted && led != points.end())
        place = led->template in<Dim>(m_pose);
    return stopMessage(reasonOf(failure), roughPlaceName<Dim>(place, m_units.size), -1);
}

template class DragFlow<2>;
template class DragFlow<3>;

}  // namespace wend
