// Steps that minimize the energy of the map from rest: settling, elastic motion, strong memory.

#include <algorithm>
#include <cmath>

#include "core/integration/integrator.h"

namespace wend {
namespace {

// These limit, for elastic shapes, how far the minimum may be from where it was predicted, in sizes and as a
// part of the predicted path; the third is how little of that a step of the least length has to allow.
constexpr double kTracked = 0.03, kTrackedPart = 0.5;
// More iterations are a sign that the branch has ended.
constexpr int kMostTracked = 15;
constexpr int kMostToMinimum = 300;
// After a minimum has ended, the next one may be this far away without being called a snap.
constexpr double kNoSnap = 0.02;
// Of the last Newton step, in sizes: quadratic convergence leaves its square.
constexpr double kMinimumTolerance = 1e-7, kProximalTolerance = 1e-5;
// The error of a step with memory that is allowed, in tolerances: it shrinks as the memory draws the shape.
constexpr double kMemoryError = 30;
// A shape whose force is less has settled.
constexpr double kSettledForce = 1e-9;

}  // namespace

/// Returns how the step from a time on relaxes.
template <int Dim>
typename Deformer<Dim>::Integrator::Relaxation Deformer<Dim>::Integrator::relaxation(double t,
                                                                                     Side side) const {
    if (std::isinf(m_memory)) return Relaxation::Elastic;
    if (m_solver && m_solver->solver() == SolverKind::Multigrid) return Relaxation::Explicit;
    if (m_settling.rate(t, side) > 0) return Relaxation::Settling;
    const bool isStrong = m_memory > kStrongMemory || (m_memory > 0 && state.pace.order == kImplicitOrder);
    return isStrong ? Relaxation::Memory : Relaxation::Explicit;
}

/// Returns the least length of an elastic step, at which the shape continues from the next minimum if the
/// current one ends.
template <int Dim>
double Deformer<Dim>::Integrator::leastElasticStep() const {
    constexpr double kRelaxedPart = 1e-3;  // of the stretch between two breakpoints
    return kRelaxedPart * stretch();
}

/// Returns whether constraints have changed so that an elastic shape is at rest elsewhere, as after a handle
/// is released.
template <int Dim>
bool Deformer<Dim>::Integrator::springs() {
    if (!std::isinf(m_memory) || state.time == 0 || lastBreakpoint(state.time) != state.time) return false;
    prescribe(state.time, Side::After, state.normalized);
    return m_solver->restForce(state.normalized) > kSettledForce;
}

/// Returns the displacements of the constrained points from a shape to their places at a time, one column
/// each.
template <int Dim>
Points<Dim> Deformer<Dim>::Integrator::displacements(double t, const Points<Dim>& shape) {
    prescribe(t, Side::Before, shape);
    Points<Dim> result = m_targets;
    for (std::size_t i = 0; i < m_ids.size(); ++i)
        result.col(static_cast<Eigen::Index>(i)) -= m_constraints->points()[m_ids[i]].template in<Dim>(shape);
    return result;
}

template <int Dim>
bool Deformer<Dim>::Integrator::failWith(const SolveOutcome& outcome, double t) {
    m_failure.outcome = outcome;
    m_failure.time = t;
    m_failure.cancelled = outcome.kind == SolveOutcome::Kind::Stopped;
    return false;
}

/// Moves a shape by a Newton step that takes the constrained points to their places at a time.
template <int Dim>
bool Deformer<Dim>::Integrator::predict(double to, Points<Dim>& shape) {
    Points<Dim> step;
    const SolveOutcome outcome = m_solver->predict(shape, displacements(to, shape), step);
    if (!outcome.done()) return failWith(outcome, to);
    shape += step;
    project(to, shape);
    const int inverted = firstInverted(shape);
    return inverted < 0 || failWith({SolveOutcome::Kind::CellInverted, inverted}, to);
}

/// Moves a shape that satisfies the constraints at a time to a minimum.
template <int Dim>
Descended Deformer<Dim>::Integrator::descend(double t, Points<Dim>& shape, double tolerance,
                                             int mostIterations) {
    Descent<Dim> descent;
    descent.tolerance = tolerance;
    descent.mostIterations = mostIterations;
    if (m_constraints->hasGuides())
        descent.keep = [this, t](Points<Dim>& moved) {
            project(t, moved);
            prescribe(t, Side::Before, moved);
        };
    const Descended result = m_solver->descend(shape, descent);
    if (!result.outcome.done()) failWith(result.outcome, t);
    return result;
}

/// Computes argmin W(x) + (1/pull) (x − x₀)ᵀ A (x − x₀) under the constraints at `to`, with x₀ and A at the
/// origin (docs/method.md, (23)). A Newton step for the displaced constraints comes first, so that the
/// descent starts from a shape that satisfies them.
template <int Dim>
bool Deformer<Dim>::Integrator::proximalStep(const Points<Dim>& origin, double to, double pull,
                                             Points<Dim>& shape) {
    shape = origin;
    if (const int cell = m_solver->setProximal(1 / pull, origin); cell >= 0)
        return failWith({SolveOutcome::Kind::CellInverted, cell}, to);
    bool good = predict(to, shape);
    if (good) {
        const Descended result = descend(to, shape, kProximalTolerance, kMostToMinimum);
        good = result.outcome.done();
    }
    m_solver->setProximal(0, origin);
    return good;
}

/// Takes a step of a settle window, docs/method.md, (25). It reports the same error every time, by which the
/// steps become longer and longer; the last one of a window ends at the minimum of W itself.
template <int Dim>
bool Deformer<Dim>::Integrator::settle(double from, double to, const Points<Dim>& start, Points<Dim>& result,
                                       double& error) {
    constexpr double kGrowth = 0.3;  // an error by which the next step is longer by a half
    error = kGrowth;
    if (!proximalStep(start, to, m_settling.rate(from, Side::After) * (to - from), result)) return false;
    if (m_settling.nextBreakpoint(from) > to) return true;
    return descend(to, result, kMinimumTolerance, kMostToMinimum).outcome.done();
}

/// Takes two steps of half the length, and one of the whole length to estimate the error.
template <int Dim>
bool Deformer<Dim>::Integrator::relaxWithMemory(double from, double to, const Points<Dim>& start,
                                                Points<Dim>& result, double& error) {
    const auto pull = [&](double t, double until) {
        prescribe(0.5 * (t + until), Side::Before, start);
        return m_memory * largestColumn<Dim>(m_prescribed) * (until - t);
    };
    const double middle = 0.5 * (from + to), whole = pull(from, to), first = pull(from, middle),
                 second = pull(middle, to);
    error = 0;
    result = start;
    if (whole == 0 || first == 0 || second == 0) {  // a motion pauses for a moment
        project(to, result);
        return true;
    }
    Points<Dim> half, rough;
    if (!proximalStep(start, to, whole, rough) || !proximalStep(start, middle, first, half) ||
        !proximalStep(half, to, second, result))
        return false;
    if (m_options.steps == 0)
        error = largestColumn<Dim>(result - rough) / (kMemoryError * m_options.tolerance);
    return true;
}

/// Moves an elastic shape to the minimum of W at the end of the step (docs/method.md, (24)), tracked from the
/// one at its start: predicted by one Newton step, corrected by the descent. The error is the correction in
/// terms of what is allowed, and infinite if the descent did not converge or passed a saddle, which are signs
/// that the branch has ended. A step of the least length is accepted in any case; it counts as a snap if the
/// correction was long, unless constraints were released there.
template <int Dim>
bool Deformer<Dim>::Integrator::track(double from, double to, const Points<Dim>& start, Points<Dim>& result,
                                      double& error) {
    const bool isLeast = to - from <= leastElasticStep() * (1 + 1e-9);
    result = start;
    if (!predict(to, result)) return false;
    const Points<Dim> predicted = result;
    const Descended descended =
        descend(to, result, kMinimumTolerance, isLeast ? kMostToMinimum : kMostTracked);
    if (!descended.outcome.done()) return false;
    const double moved = largestColumn<Dim>(result - predicted), way = largestColumn<Dim>(predicted - start);
    error = moved / std::max(kTracked, kTrackedPart * way);
    if (!descended.isConverged || !descended.isStable) error = std::numeric_limits<double>::infinity();
    if (!isLeast) return true;
    m_snapped.reset();
    if (moved > std::max(kNoSnap, 2 * way) && !m_springing) {
        Eigen::Index vertex = 0;
        (result - predicted).colwise().norm().maxCoeff(&vertex);
        m_snapped = static_cast<int>(vertex);
    }
    error = std::min(error, 1.0);
    return true;
}

/// Takes a step by the kind of relaxation that acts there, and measures its error.
template <int Dim>
bool Deformer<Dim>::Integrator::relax(double from, double to, const Points<Dim>& start, Points<Dim>& result,
                                      double& error) {
    m_snapped.reset();
    m_solver->setStop(m_watch ? m_watch->stop : std::stop_token());
    ++statistics.evaluations;
    switch (relaxation(from, Side::After)) {
        case Relaxation::Settling:
            return settle(from, to, start, result, error);
        case Relaxation::Memory:
            return relaxWithMemory(from, to, start, result, error);
        default:
            return track(from, to, start, result, error);
    }
}

/// Moves an elastic shape between two steps to the minimum at that time; a frame of another motion stays.
template <int Dim>
void Deformer<Dim>::Integrator::relaxFrame(double t, Points<Dim>& shape) {
    if (!std::isinf(m_memory)) return;
    const Points<Dim> before = shape;
    m_solver->setStop({});
    if (!descend(t, shape, kMinimumTolerance, kMostTracked).outcome.done() || firstInverted(shape) >= 0)
        shape = before;
    m_failure = {};
}

/// Leads an elastic shape from an end of a step to a frame within it, in as many parts as it takes without a
/// fold. Returns false, and leaves the shape, if there are too many, or for other motions.
template <int Dim>
bool Deformer<Dim>::Integrator::leadElastic(double from, const Points<Dim>& start, double to,
                                            Points<Dim>& shape) {
    constexpr int kMostRelaxedParts = 16;
    if (!std::isinf(m_memory)) return false;
    m_solver->setStop({});
    bool good = false;
    for (int parts = 1; parts <= kMostRelaxedParts && !good; parts *= 2) {
        Points<Dim> led = start;
        good = true;
        for (int k = 1; k <= parts && good; ++k) {
            const double t = std::lerp(from, to, double(k) / parts);
            good = predict(t, led) && descend(t, led, kMinimumTolerance, kMostTracked).outcome.done();
        }
        good = good && firstInverted(led) < 0;
        if (good) shape = led;
    }
    m_failure = {};
    return good;
}

/// Computes the velocity of an elastic shape, which moves with the derivative of the minimizer.
template <int Dim>
bool Deformer<Dim>::Integrator::elasticVelocity(double t, Side side, const Points<Dim>& shape,
                                                Points<Dim>& velocity) {
    m_failure = {};
    prescribe(t, side, shape);
    m_solver->setStop(m_watch ? m_watch->stop : std::stop_token());
    const SolveOutcome outcome = m_solver->predict(shape, m_prescribed, velocity);
    return outcome.done() || failWith(outcome, t);
}

/// Computes the velocities at the ends of an elastic step; there are none for other motions.
template <int Dim>
std::optional<typename Deformer<Dim>::Integrator::EndVelocities> Deformer<Dim>::Integrator::endVelocities(
    double from, double to) {
    if (!std::isinf(m_memory)) return {};
    // The step is done: a wish to stop does not count before the frames in it are out.
    const Watch* const watch = std::exchange(m_watch, nullptr);
    EndVelocities v;
    const bool good = elasticVelocity(from, Side::After, state.normalized, v.start) &&
                      elasticVelocity(to, Side::Before, m_next, v.end);
    m_watch = watch;
    m_failure = {};
    if (!good) return {};
    return v;
}

/// Moves an interpolated elastic shape to the cubic polynomial through the ends of the step with their
/// velocities, if that is nearer to the minimum. It is not where the shape snaps or springs in the step.
template <int Dim>
void Deformer<Dim>::Integrator::refineFrame(double from, double to, double t, const EndVelocities& v,
                                            Points<Dim>& shape) {
    const double h = to - from, s = (t - from) / h, r = 1 - s;
    Points<Dim> cubic = r * r * (1 + 2 * s) * state.normalized + s * s * (1 + 2 * r) * m_next +
                        h * s * r * (r * v.start - s * v.end);
    project(t, cubic);
    if (firstInverted(cubic) >= 0) return;
    if (firstInverted(shape) >= 0 || m_solver->restEnergy(cubic) < m_solver->restEnergy(shape)) shape = cubic;
}

template bool Deformer<2>::Integrator::springs();
template bool Deformer<2>::Integrator::relax(double, double, const Points2&, Points2&, double&);
template void Deformer<2>::Integrator::relaxFrame(double, Points2&);
template bool Deformer<2>::Integrator::leadElastic(double, const Points2&, double, Points2&);
template bool Deformer<2>::Integrator::elasticVelocity(double, Side, const Points2&, Points2&);
template std::optional<Deformer<2>::Integrator::EndVelocities> Deformer<2>::Integrator::endVelocities(double,
                                                                                                      double);
template void Deformer<2>::Integrator::refineFrame(double, double, double, const EndVelocities&, Points2&);
template double Deformer<2>::Integrator::leastElasticStep() const;
template Deformer<2>::Integrator::Relaxation Deformer<2>::Integrator::relaxation(double, Side) const;
template bool Deformer<3>::Integrator::springs();
template bool Deformer<3>::Integrator::relax(double, double, const Points3&, Points3&, double&);
template void Deformer<3>::Integrator::relaxFrame(double, Points3&);
template bool Deformer<3>::Integrator::leadElastic(double, const Points3&, double, Points3&);
template bool Deformer<3>::Integrator::elasticVelocity(double, Side, const Points3&, Points3&);
template std::optional<Deformer<3>::Integrator::EndVelocities> Deformer<3>::Integrator::endVelocities(double,
                                                                                                      double);
template void Deformer<3>::Integrator::refineFrame(double, double, double, const EndVelocities&, Points3&);
template double Deformer<3>::Integrator::leastElasticStep() const;
template Deformer<3>::Integrator::Relaxation Deformer<3>::Integrator::relaxation(double, Side) const;

}  // namespace wend
