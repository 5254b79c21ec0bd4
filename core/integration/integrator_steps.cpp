// The stepping of the integrator.

#include <algorithm>
#include <cmath>

#include "core/integration/integrator.h"

namespace wend {

/// Returns the next time after the current one where a step has to end: the wanted time, a breakpoint or,
/// with prescribed steps, the next multiple of their width. The factors next to 1 put a time that is such a
/// multiple up to rounding on it.
template <int Dim>
double Deformer<Dim>::Integrator::nextStop(double time) const {
    double stop = std::min(time, nextBreakpoint(state.time));
    if (m_options.steps == 0 || !flows(state.time, Side::After)) return stop;
    const double width = m_options.end / m_options.steps;
    const double number = std::floor(state.time / width * (1 + 1e-14) + 1e-9) + 1;
    const double grid = number == m_options.steps ? m_options.end : number * width;
    return grid > stop - 1e-9 * width ? stop : grid;  // no sliver of a step before a breakpoint
}

/// Estimates the first step from the largest speed of the constrained points up to the next breakpoint (a
/// motion may ease in) and from the rate of the memory.
template <int Dim>
double Deformer<Dim>::Integrator::startStep(double to) const {
    constexpr int kSamples = 16;
    constexpr double kFirstDecay = 0.3;  // of an implicit step
    double fastest = 0;
    Points<Dim> positions, velocities;
    for (int i = 0; i <= kSamples; ++i) {
        const double t = state.time + (to - state.time) * i / kSamples;
        m_constraints->evaluate(m_ids, state.anchors, t, i == kSamples ? Side::Before : Side::After,
                                positions, velocities);
        const double speed = largestColumn<Dim>(velocities);
        if (!std::isfinite(speed)) return 0;  // no step is small enough
        fastest = std::max(fastest, speed);
    }
    if (m_springing) return std::min(leastElasticStep(), to - state.time);
    const Relaxation kind = relaxation(state.time, Side::After);
    if (kind == Relaxation::Settling)
        return std::max(kFirstDecay / m_settling.rate(state.time, Side::After), smallestStep());
    const double settling = m_settling.rate(state.time, Side::After), rate = kind == Relaxation::Elastic ? 0
                                                                             : settling > 0
                                                                                 ? settling
                                                                                 : m_memory * fastest;
    const double step = fastest > 0 ? method().firstStep(fastest) : to - state.time;
    return rate > 0 ? std::min(step, 1 / rate) : step;
}

/// Returns the next time on the way to a stop, without a tiny step before it. A rest that is a little longer
/// than the step is taken as a whole, and one of up to two steps in two halves.
template <int Dim>
double Deformer<Dim>::Integrator::proposedStep(double stop) const {
    const double rest = stop - state.time;
    if (m_options.steps > 0) return stop;
    const double step = state.pace.step;
    if (step >= 0.95 * rest) return stop;
    return step > 0.5 * rest ? state.time + 0.5 * rest : state.time + step;
}

/// Returns the length of the stretch between two breakpoints that the current time is in; 1 after the last.
template <int Dim>
double Deformer<Dim>::Integrator::stretch() const {
    const double from = std::max(0.0, lastBreakpoint(state.time)), to = nextBreakpoint(state.time);
    return std::isfinite(to) ? to - from : 1;
}

template <int Dim>
double Deformer<Dim>::Integrator::smallestStep() const {
    return m_options.smallestStep * stretch();
}

/// Tries to step from the current state to a time. Returns the error over the tolerance (0 for fixed steps),
/// or nothing with the reason in m_failure if a field could not be computed or the result has an inverted
/// cell. Only a result whose error is allowed is projected and examined.
template <int Dim>
std::optional<double> Deformer<Dim>::Integrator::attempt(const Nodal<Dim>& start, double to) {
    const auto rhs = [this](double t, Side side, StageVectors<Dim>&, Points<Dim>& v) {
        return evaluate(t, side, v);
    };
    if (m_solver->reuses() && relaxation(state.time, Side::After) == Relaxation::Explicit)
        m_history.begin(state.time, to, start, [this](const auto& from, const auto& shape, auto& fields) {
            m_solver->turn(from, shape, fields);
        });
    m_progress.begin(state.time, to);
    if (!method().attempt(rhs, m_solver->stages(), state.time, to, start, state.pace)) return {};
    m_progress.succeed();
    const double error = method().error();
    if (!(error <= 1)) return error;
    m_next = *method().result();
    project(to, m_next);
    const int inverted = firstInverted(m_next);
    if (inverted < 0) return error;
    const bool finite = std::isfinite(cellMeasure<Dim>(m_next, m_rest->cells[inverted]));
    m_failure.outcome = finite ? SolveOutcome{SolveOutcome::Kind::CellInverted, inverted}
                               : SolveOutcome{SolveOutcome::Kind::NotFinite, -1};
    m_failure.time = to;
    return {};
}

/// If the step would become too small and a cell is nearly flat, that cell is reported as the cause.
constexpr double kNearlyFlat = 1e-2;  // relative to the cell's rest measure
/// Records why the next step would be too short: a cell is nearly flat or, if there is none, no reason is
/// known.
template <int Dim>
void Deformer<Dim>::Integrator::failForSmallStep(double to) {
    m_failure = {};
    m_failure.time = to;
    const int cell = m_orientation.mostShrunk(state.normalized);
    const double ratio = cellMeasure<Dim>(state.normalized, m_rest->cells[cell]) /
                         cellMeasure<Dim>(m_rest->points, m_rest->cells[cell]);
    if (ratio < kNearlyFlat)
        m_failure.outcome = {SolveOutcome::Kind::CellInverted, cell};
    else
        m_failure.stepTooSmall = true;
}

/// Returns whether memory has made explicit steps so short that implicit ones should take over.
template <int Dim>
bool Deformer<Dim>::Integrator::isTooStiff() const {
    constexpr double kShort = 100;  // smallest steps
    return m_memory > 0 && m_options.steps == 0 && state.pace.step < kShort * smallestStep() &&
           m_solver->solver() == SolverKind::Direct &&
           relaxation(state.time, Side::After) == Relaxation::Explicit;
}

/// Makes one accepted step towards a stop, after as many attempts as needed. Returns false with m_failure if
/// the run ends. Too large an error lets the method choose a shorter step, a failure halves it. The run ends
/// where the step falls below the smallest one. A stop leaves the pace as it was, so that the continued run
/// takes the same steps.
template <int Dim>
bool Deformer<Dim>::Integrator::step(double stop) {
    const Pace<Dim> before = state.pace;
    if (state.pace.step == 0) state.pace.step = startStep(nextBreakpoint(state.time));
    if (!(state.pace.step >= smallestStep()) && m_options.steps == 0) {
        failForSmallStep(state.time);
        state.pace = before;
        return false;
    }
    double to = proposedStep(stop);
    bool shortened = false;
    const bool cut = to < state.time + state.pace.step;
    const auto start = std::make_shared<const Points<Dim>>(state.normalized);
    for (;;) {
        m_failure = {};
        const std::optional<double> error = attempt(start, to);
        if (error && *error <= 1) {
            accept(to, shortened, cut && !shortened);
            return true;
        }
        if (m_failure.cancelled) {
            state.pace = before;  // as if nothing had been tried: going on gives the same bits
            return false;
        }
        if (solveDirectly()) continue;
        ++statistics.rejected;
        if (m_failure.outcome.kind == SolveOutcome::Kind::NotConverged) return false;  // nor in a shorter one
        if (error)
            method().retry(state.pace);
        else
            state.pace.step = 0.5 * (to - state.time);
        if (isTooStiff()) {  // implicitly from here to the next breakpoint
            state.pace = {};
            state.pace.order = kImplicitOrder;
            state.pace.step = startStep(nextBreakpoint(state.time));
        }
        const double h = state.pace.step;
        if (h < smallestStep() || state.time + h == state.time) {
            if (error) failForSmallStep(to);
            return false;
        }
        shortened = true;
        to = state.time + h;
    }
}

/// Accepts a step: counts it, remembers what the next one depends on, emits the frames within it, and moves
/// the state to its end.
template <int Dim>
void Deformer<Dim>::Integrator::accept(double to, bool shortened, bool cut) {
    ++statistics.steps;
    const bool isExplicit = relaxation(state.time, Side::After) == Relaxation::Explicit;
    if (m_options.steps == 0 && isExplicit)
        statistics.errorEstimate += method().error() * m_options.tolerance;
    remember();  // frames may need a field of their own
    StepRecord<Dim> made{state.time, to, nullptr, endField(state.time, to), {}};
    if (m_watch && m_watch->onStep) made.dense = method().dense();
    emitFrames(state.time, to, made.endField);
    state.normalized = m_next;
    method().accept(state.pace, shortened, cut);
    arrive(to);
    if (m_snapped) statistics.snaps.push_back(snapAt(*m_snapped));
    record(std::move(made));
}

template <int Dim>
Snap Deformer<Dim>::Integrator::snapAt(int vertex) const {
    Snap snap{state.time, {}};
    for (int k = 0; k < Dim; ++k) snap.place[static_cast<std::size_t>(k)] = state.points(k, vertex);
    return snap;
}

/// Passes on the step with the shape at its end, unless nothing moved.
template <int Dim>
void Deformer<Dim>::Integrator::record(StepRecord<Dim> step) {
    if (!m_watch || !m_watch->onStep) return;
    collectStatistics();
    if (!step.dense.fields.empty()) step.next = std::make_shared<const Points<Dim>>(m_next);
    m_watch->onStep(step);
}

/// Takes a step of the source. After the last one the state is that with which the earlier run continued.
template <int Dim>
void Deformer<Dim>::Integrator::takeKnownStep() {
    StepSource<Dim>& known = *m_watch->known;
    repeat(known.next());
    if (known.hasNext()) return;
    known.resume(state, m_before);
    statistics = m_before;
}

/// Does what accept() and standStill() do after a computed step.
template <int Dim>
void Deformer<Dim>::Integrator::repeat(const StepRecord<Dim>& step) {
    if (!step.next) {
        emitStanding(step.to);
    } else {
        method().adopt(step.dense, step.from, step.to, std::make_shared<const Points<Dim>>(state.normalized));
        m_next = *step.next;
        emitFrames(step.from, step.to, step.endField);
        state.normalized = m_next;
    }
    arrive(step.to);
}

/// Emits the frames before a time up to which nothing moves.
template <int Dim>
void Deformer<Dim>::Integrator::emitStanding(double to) {
    for (; hasFramesBefore(to); ++m_frame) {
        State<Dim> frame;
        frame.time = m_watch->frames[m_frame];
        frame.points = state.points;
        m_watch->onFrame(frame);
    }
}

/// Advances while no handle moves: v̂ = 0, and there is nothing to solve.
template <int Dim>
void Deformer<Dim>::Integrator::standStill(double to) {
    const double from = state.time;
    m_next = state.normalized;
    emitStanding(to);
    ++statistics.steps;
    arrive(to);
    record({from, to, nullptr, nullptr, {}});
}

/// Moves the state to a time, and its anchors across a breakpoint there.
template <int Dim>
void Deformer<Dim>::Integrator::arrive(double to) {
    state.time = to;
    state.points = inDomain(state.normalized);
    measureError(to);
    if (lastBreakpoint(to) == to) {
        m_constraints->crossBreakpoint(to, state.normalized, state.anchors);
        startAnew();
    }
    if (m_watch && m_watch->progress) m_watch->progress(to);
}

/// Measures how far the constrained points are from their prescribed positions.
template <int Dim>
void Deformer<Dim>::Integrator::measureError(double t) {
    prescribe(t, Side::Before, state.normalized);
    for (size_t i = 0; i < m_ids.size(); ++i) {
        const bool isHeldElsewhere =
            m_constraints->points()[m_ids[i]].isGuided() && std::ranges::count(m_guided, m_ids[i]) == 0;
        if (isHeldElsewhere) continue;
        const Vec<Dim> p = m_constraints->points()[m_ids[i]].template in<Dim>(state.normalized);
        const double distance =
            m_constraints->deviation(m_ids[i], p - m_targets.col(static_cast<Eigen::Index>(i))).norm();
        statistics.constraintError = std::max(statistics.constraintError, distance);
    }
}

template double Deformer<2>::Integrator::nextStop(double) const;
template double Deformer<2>::Integrator::stretch() const;
template double Deformer<3>::Integrator::stretch() const;
template bool Deformer<2>::Integrator::step(double);
template void Deformer<2>::Integrator::standStill(double);
template void Deformer<2>::Integrator::takeKnownStep();
template double Deformer<3>::Integrator::nextStop(double) const;
template bool Deformer<3>::Integrator::step(double);
template void Deformer<3>::Integrator::standStill(double);
template void Deformer<3>::Integrator::takeKnownStep();

}  // namespace wend
