#include "core/integration/integrator.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/error.h"
#include "core/integration/contradictions.h"
#include "core/integration/implicit_method.h"

namespace wend {

namespace {

/// Returns the velocity tolerance. Errors of the fields disturb the step control. With prescribed steps there
/// is no control; the result then differs from that of exact fields by a fraction of the tolerance, so tight
/// tolerances are still honoured.
double velocityTolerance(const IntegrationOptions& options) {
    constexpr double kGivenSteps = 4, kManyDigits = 1e-6;
    if (options.velocityTolerance >= 0) return options.velocityTolerance;
    const bool looser = options.steps > 0 && options.tolerance > kManyDigits;
    return (looser ? kGivenSteps : 1) * velocityToleranceFor(options.tolerance);
}

}  // namespace

template <int Dim>
Deformer<Dim>::Integrator::Integrator(std::shared_ptr<const SimplicialMesh<Dim>> rest,
                                      std::shared_ptr<const Material<Dim>> material,
                                      const std::vector<Handle<Dim>>& handles,
                                      const IntegrationOptions& options, SolverFactory makeSolver)
    : m_options(options),
      m_units((requireValid<Dim>(*rest), Normalization<Dim>::of(*rest))),
      m_domainRest(std::move(rest)),
      m_rest(std::make_shared<const SimplicialMesh<Dim>>(m_units.normal(*m_domainRest))),
      m_twins(twinsOf<Dim>(*m_domainRest)),
      m_orientation(m_rest),
      m_domainOrientation(m_domainRest),
      m_makeSolver(std::move(makeSolver)),
      m_settling(options.settle),
      m_memory(material->memory),
      m_method(StepMethod<Dim>::of(options.method, options.steps > 0 ? 0 : options.tolerance)) {
    if (options.method == Method::Adams && options.steps == 0)
        m_settlingMethod = StepMethod<Dim>::of(Method::DormandPrince, options.tolerance);
    m_implicit = std::make_unique<ImplicitMethod<Dim>>(
        [this](double t, double to, const Nodal<Dim>& x, Points<Dim>& result, double& error) {
            return relax(t, to, *x, result, error);
        },
        [this](double t) { return m_settling.rate(t, Side::After); });
    if (const std::string problem = options.problem(); !problem.empty()) throw InputError(problem);
    requireValid<Dim>(*material, m_rest->cellCount());
    state.points = m_domainRest->points;
    state.normalized = m_rest->points;
    setHandles(handles);
    m_solver = std::make_unique<VelocitySolver<Dim>>(m_makeSolver(m_rest, m_options.solver));
    m_solver->setVelocityTolerance(velocityTolerance(m_options));
    if (std::isinf(m_memory) && m_solver->solver() == SolverKind::Multigrid)
        throw InputError(
            "an elastic shape needs the direct solver, for which this one is too large: use fewer "
            "vertices, or a memory that is a number");
    collectStatistics();
}

/// Normalizes the handles, and continues with their constraints from the current time.
template <int Dim>
void Deformer<Dim>::Integrator::setHandles(const std::vector<Handle<Dim>>& handles) {
    std::vector<Handle<Dim>> moved;
    moved.reserve(handles.size());
    for (const Handle<Dim>& handle : handles) moved.push_back(m_units.normal(handle));
    const auto constraints = std::make_shared<const Constraints<Dim>>(*m_rest, moved, m_units);
    requireConsistent(*constraints, m_rest->points, m_units);
    startAnew();                     // the fields belong to the old motions,
    statistics.constraintError = 0;  // and so do the errors
    m_constraints = constraints;
    restore(State<Dim>(state));
}

/// Continues from a state. A state without a normalized shape is normalized here; it then continues, but not
/// to the same bits.
template <int Dim>
void Deformer<Dim>::Integrator::restore(const State<Dim>& from) {
    if (from.points.cols() != m_rest->vertexCount()) {
        throw InputError("a state of " + std::to_string(from.points.cols()) + " vertices for a shape of " +
                         std::to_string(m_rest->vertexCount()));
    }
    state = from;
    if (state.normalized.cols() != state.points.cols()) {
        state.normalized = m_rest->points + (state.points - m_domainRest->points) / m_units.size;
        startAnew();
    }
    const auto points =
        std::shared_ptr<const std::vector<ConstrainedPoint>>(m_constraints, &m_constraints->points());
    const std::vector<ConstrainedPoint> none;
    state.anchors = m_constraints->adopt(from.constrained ? *from.constrained : none, from.anchors,
                                         state.normalized, state.time);
    state.constrained = points;
    if (lastBreakpoint(state.time) == state.time) startAnew();
}

template <int Dim>
void Deformer<Dim>::Integrator::startAnew() {
    state.pace = {};
    state.history = {};
    state.factor = {};
}

/// Restores guesses, once the constraints are those of the current time.
template <int Dim>
void Deformer<Dim>::Integrator::recall() {
    m_history = state.history;
    m_solver->recall(state.factor);
}

template <int Dim>
void Deformer<Dim>::Integrator::remember() {
    state.history = m_history;
    state.factor = m_solver->remember();
}

/// Adds the displacement to the rest position, so that what does not move keeps its bits.
template <int Dim>
Points<Dim> Deformer<Dim>::Integrator::inDomain(const Points<Dim>& shape) const {
    Points<Dim> points = m_domainRest->points + m_units.size * (shape - m_rest->points);
    takeAlong<Dim>(m_twins, points);
    return points;
}

/// Returns the first cell that is inverted in the computational frame or in the rounded output coordinates;
/// −1 for none.
template <int Dim>
int Deformer<Dim>::Integrator::firstInverted(const Points<Dim>& shape) const {
    const int cell = m_orientation.firstInverted(shape);
    return cell >= 0 ? cell : m_domainOrientation.firstInverted(inDomain(shape));
}

/// Activates the constraints that hold on one side of the current time.
template <int Dim>
void Deformer<Dim>::Integrator::activate(Side side) {
    m_activeSide = side;
    m_ids = m_constraints->activePoints(state.time, side);
    const std::vector<int> sliding = m_constraints->activeSliders(state.time, side);
    m_solver->setConstraints(rowsOf(*m_constraints, m_ids), slidersOf(*m_constraints, sliding));
    m_sliders = static_cast<Eigen::Index>(sliding.size());
    m_guided = guidedAlone(*m_constraints, m_ids, sliding);
    m_ids.insert(m_ids.end(), sliding.begin(), sliding.end());
}

/// Evaluates the constraints at a time and, for points that slide on surfaces, at a shape.
template <int Dim>
void Deformer<Dim>::Integrator::prescribe(double t, Side side, const Points<Dim>& shape) {
    m_constraints->evaluate(m_ids, state.anchors, t, side, m_targets, m_prescribed);
    if (!m_constraints->hasGuides()) return;
    m_constraints->guide(m_ids, shape, t, side, m_targets, m_prescribed, m_directions);
    m_solver->setDirections(m_directions.rightCols(m_sliders));
}

/// Returns whether a handle moves or the shape relaxes.
template <int Dim>
bool Deformer<Dim>::Integrator::flows(double t, Side side) const {
    return m_constraints->moving(t, side) || m_settling.rate(t, side) > 0;
}

template <int Dim>
double Deformer<Dim>::Integrator::nextBreakpoint(double t) const {
    return std::min(m_constraints->nextBreakpoint(t), m_settling.nextBreakpoint(t));
}

template <int Dim>
double Deformer<Dim>::Integrator::lastBreakpoint(double t) const {
    return std::max(m_constraints->lastBreakpoint(t), m_settling.lastBreakpoint(t));
}

/// Returns the method of the step from the current time. Relaxation is stiff; with multigrid, which has no
/// factor for Newton's method, it is explicit, and Adams methods have too small stability regions.
template <int Dim>
StepMethod<Dim>& Deformer<Dim>::Integrator::method() const {
    if (relaxation(state.time, Side::After) != Relaxation::Explicit) return *m_implicit;
    return m_settlingMethod && m_settling.rate(state.time, Side::After) > 0 ? *m_settlingMethod : *m_method;
}

/// Returns the factor of the gradient of W: during relaxation that of the interval, else ρ times the largest
/// speed of a constrained point in m_prescribed (docs/method.md, (22) and (25)).
template <int Dim>
double Deformer<Dim>::Integrator::memoryRate(double t, Side side) const {
    const double settling = m_settling.rate(t, side);
    return settling > 0 ? settling : m_memory * largestColumn<Dim>(m_prescribed);
}

/// Evaluates dx/dt = v̂(x, t) at the stages' shape (docs/method.md, (16)), constrained points as all others.
/// A guess of the history saves iterations only where factors are reused. Returns false with the reason in
/// m_failure, whose time is t.
template <int Dim>
bool Deformer<Dim>::Integrator::evaluate(double t, Side side, Points<Dim>& velocity) {
    m_failure = {};
    m_failure.time = t;
    if (m_watch && m_watch->stop.stop_requested()) {
        m_failure.cancelled = true;
        return false;
    }
    // The shape of a stage may have to be copied from a device.
    prescribe(t, side, m_constraints->hasGuides() ? *m_solver->stages().shape() : state.normalized);
    m_solver->setMemoryRate(memoryRate(t, side));
    m_solver->setStop(m_watch ? m_watch->stop : std::stop_token());
    if (m_watch && m_watch->within)
        m_solver->setProgress([this](FieldWork work, double part) { m_progress.tell(work, part); });
    else
        m_solver->setProgress({});
    ++statistics.evaluations;
    const bool reuses = m_solver->reuses();
    m_failure.outcome =
        m_solver->solveAtStage(m_prescribed, velocity, reuses ? m_history.at(t) : std::nullopt);
    m_failure.cancelled = m_failure.outcome.kind == SolveOutcome::Kind::Stopped;
    if (reuses && m_failure.outcome.done()) m_history.record(t, m_prescribed, velocity);
    if (m_failure.outcome.done()) m_progress.fieldDone();
    return m_failure.outcome.done();
}

/// Replaces multigrid by factors for the rest of the run, if its iterations did not converge, it was chosen
/// automatically, and the factors fit into memory. Returns whether it did.
template <int Dim>
bool Deformer<Dim>::Integrator::solveDirectly() {
    if (m_failure.outcome.kind != SolveOutcome::Kind::NotConverged ||
        m_options.solver != SolverKind::Automatic ||
        !fitsDirectly(Dim, m_rest->vertexCount(), machineMemory()))
        return false;
    collectStatistics();
    m_before = statistics;
    m_solver.reset();
    m_solver = std::make_unique<VelocitySolver<Dim>>(m_makeSolver(m_rest, SolverKind::Direct));
    m_solver->setVelocityTolerance(velocityTolerance(m_options));
    activate(m_activeSide);
    return true;
}

/// Points that slide on surfaces and other constraints take turns, until both hold to rounding. The
/// correction of docs/method.md, (17), changes the points that slide, and putting these on their surfaces
/// changes the others, but by less in every turn.
template <int Dim>
void Deformer<Dim>::Integrator::project(double t, Points<Dim>& shape) {
    constexpr int kMostTurns = 50;
    constexpr double kOnSurface = 1e-14;  // of the size, which is 1
    m_constraints->evaluate(m_ids, state.anchors, t, Side::Before, m_targets, m_prescribed);
    m_solver->project(shape, m_targets);
    if (m_guided.empty()) return;
    for (int k = 0; k < kMostTurns; ++k) {
        if (m_constraints->pull(m_guided, t, Side::Before, shape) <= kOnSurface) return;
        m_solver->project(shape, m_targets);
    }
}

/// Dense output ignores orientation: an interpolated shape with an inverted cell is blended towards the
/// nearer end of the step, with its constrained points at their places at time t. If that does not help, it
/// becomes that end.
template <int Dim>
void Deformer<Dim>::Integrator::unfold(double t, Points<Dim>& shape, const Points<Dim>& end) {
    constexpr int kHalvings = 8;
    for (int k = 0; firstInverted(shape) >= 0; ++k) {
        if (k == kHalvings) {
            shape = end;
            return;
        }
        shape = 0.5 * (shape + end);
        project(t, shape);
    }
}

template <int Dim>
bool Deformer<Dim>::Integrator::hasFramesBefore(double to) const {
    return m_watch && m_watch->onFrame && m_frame < m_watch->frames.size() && m_watch->frames[m_frame] < to;
}

/// Returns the field at the end of the step that m_method holds, where the method needs it for frames or for
/// a record of the step; null otherwise. If the field cannot be computed, the mean velocity of the step
/// replaces it: frames must not make a run fail.
template <int Dim>
Nodal<Dim> Deformer<Dim>::Integrator::endField(double from, double to) {
    const bool isWanted = hasFramesBefore(to) || (m_watch && m_watch->onStep);
    if (!isWanted || !method().needsEndField()) return nullptr;
    auto field = std::make_shared<Points<Dim>>();
    // The step is done: a wish to stop does not count before the frames in it are out.
    const Watch* const watch = std::exchange(m_watch, nullptr);
    m_solver->stages().combine(std::make_shared<const Points<Dim>>(m_next), {});
    if (!evaluate(to, Side::Before, *field)) *field = (m_next - state.normalized) / (to - from);
    m_watch = watch;
    return field;
}

/// Emits the frames strictly inside the step that m_method holds; one at its end is the state itself. A frame
/// is the method's interpolant with its constrained points put on their paths. If that has an inverted cell,
/// an elastic shape is led there from the nearer end of the step, and any other is blended towards that end.
template <int Dim>
void Deformer<Dim>::Integrator::emitFrames(double from, double to, const Nodal<Dim>& endField) {
    const Points<Dim> none;
    const auto velocities = hasFramesBefore(to) ? endVelocities(from, to) : std::nullopt;
    for (; hasFramesBefore(to); ++m_frame) {
        const double time = m_watch->frames[m_frame];
        Points<Dim> shape = method().at(time, endField ? *endField : none);
        project(time, shape);
        if (velocities) refineFrame(from, to, time, *velocities, shape);
        const bool isEarly = 2 * time < from + to;
        const Points<Dim>& near = isEarly ? state.normalized : m_next;
        if (firstInverted(shape) < 0 || !leadElastic(isEarly ? from : to, near, time, shape)) {
            unfold(time, shape, near);
            relaxFrame(time, shape);
        }
        State<Dim> frame;
        frame.time = time;
        frame.points = inDomain(shape);
        m_watch->onFrame(frame);
    }
}

/// Takes one step further towards a time. Returns false if the run ends; m_failure says why.
template <int Dim>
bool Deformer<Dim>::Integrator::goesOn(double time) {
    activate(Side::After);
    if (m_watch->stop.stop_requested()) {
        m_failure = {};
        m_failure.cancelled = true;
        return false;
    }
    if (m_watch->known && m_watch->known->hasNext()) {
        takeKnownStep();
        return true;
    }
    m_springing = springs();
    if (m_springing || flows(state.time, Side::After)) {
        recall();
        return step(nextStop(time));
    }
    standStill(nextStop(time));
    return true;
}

/// Takes steps up to `time`, or up to the first failure, and emits the frames within each accepted step.
template <int Dim>
AdvanceResult Deformer<Dim>::Integrator::advance(double time, const Watch& watch) {
    const auto begin = std::chrono::steady_clock::now();
    m_watch = &watch;
    m_progress.start(state.time, watch.within, watch.withinEvery);
    m_frame = 0;
    bool good = true;
    const auto emitHere = [&] {
        for (; m_frame < watch.frames.size() && watch.frames[m_frame] <= state.time; ++m_frame) {
            if (watch.onFrame) watch.onFrame(state);
        }
    };
    emitHere();
    while (good && state.time < std::min(time, watch.enough)) {
        good = goesOn(time);
        if (good) emitHere();
    }
    m_watch = nullptr;
    m_progress.stop();
    statistics.integrate += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    collectStatistics();
    return good ? AdvanceResult{Outcome::Done, state.time, -1, {}} : stopped();
}

/// Solves for v̂ at the current state. Between two motions the one that begins counts. The state stays as it
/// is.
template <int Dim>
Points<Dim> Deformer<Dim>::Integrator::velocity(const std::stop_token& stop) {
    const bool begins = flows(state.time, Side::After);
    const Side side = begins || !flows(state.time, Side::Before) ? Side::After : Side::Before;
    activate(side);
    const auto anchors =
        std::exchange(state.anchors, m_constraints->anchors(state.normalized, state.time, side));
    Points<Dim> v;
    Watch watch;
    watch.stop = stop;
    m_watch = &watch;
    const auto evaluateExactly = [&] {
        if (relaxation(state.time, side) == Relaxation::Elastic)
            return elasticVelocity(state.time, side, state.normalized, v);
        m_solver->setVelocityTolerance(0);
        m_solver->stages().combine(std::make_shared<const Points<Dim>>(state.normalized), {});
        return evaluate(state.time, side, v);
    };
    const bool good = evaluateExactly() || (solveDirectly() && evaluateExactly());
    m_watch = nullptr;
    m_solver->setVelocityTolerance(velocityTolerance(m_options));
    state.anchors = anchors;
    collectStatistics();
    if (!good) return Points<Dim>(Dim, 0);
    v *= m_units.size;
    takeAlong<Dim>(m_twins, v);
    return v;
}

/// Uses the constraints up to the current time.
template <int Dim>
double Deformer<Dim>::Integrator::restForce() {
    activate(flows(state.time, Side::Before) ? Side::Before : Side::After);
    prescribe(state.time, m_activeSide, state.normalized);
    return m_solver->restForce(state.normalized);
}

/// Adds the statistics of the solver to those of the runs before.
template <int Dim>
void Deformer<Dim>::Integrator::collectStatistics() {
    const SolverStatistics& solver = m_solver->statistics();
    statistics.factorizations = m_before.factorizations + solver.factorizations;
    statistics.solverIterations = m_before.solverIterations + solver.iterations;
    statistics.analyze = m_before.analyze + solver.analyze;
    statistics.assemble = m_before.assemble + solver.assemble;
    statistics.factor = m_before.factor + solver.factor;
    statistics.solve = m_before.solve + solver.solve;
    statistics.needed = std::max(m_before.needed, solver.needed);
    statistics.energy = statistics.evaluations > m_before.evaluations ? m_solver->energy() : m_before.energy;
    statistics.copied = m_solver->copied();
}

template struct Deformer<2>::Integrator;
template struct Deformer<3>::Integrator;

}  // namespace wend
