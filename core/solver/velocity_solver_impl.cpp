#include "core/solver/velocity_solver_impl.h"

#include <algorithm>
#include <cmath>

#include "core/assembly/cpu_back_end.h"
#include "core/base/error.h"
#include "core/solver/components.h"
#include "core/solver/flat_points.h"
#include "core/solver/stopwatch.h"

namespace wend {
namespace {

// Weight of the mass matrix in parts with too few constraints: 1e-8 is off by 1 %, 1 by 2 % (docs/method.md
// (15), Constraints).
constexpr double kMassRegularization = 1e-4;
// Refine while the residual, relative to the right-hand side, is above this: only the stiffest materials need
// it.
constexpr double kResidual = 1e-10;
constexpr int kRefinements = 3;
// Below this tolerance, iterations with a stale factor save nothing.
constexpr double kMinTolerance = 1e-8;
// Above this, at its own shape, a factor in single precision costs more iterations than one in double would,
// and they show so little of the error that they would end too early.
constexpr double kPoorestContraction = 0.33;
// Multigrid: what rounding allows, and when the run ends with a message.
constexpr double kMultigridTolerance = 1e-9;
constexpr int kMostWithMultigrid = 300;
constexpr int kTrials = 3;  // attempts before an expensive factor is discarded
// Above this ratio w_r / w_q (EQUIA is 512) a factor does not last: it would need hundreds of iterations.
constexpr double kStiffestReuse = 20;
// Above this ratio (METR is 2, AKVF 0) the factor is turned with the shape.
constexpr double kTurningRatio = 0.5;

void requireRow(const ConstraintRow& row, int vertexCount) {
    double largest = 0;
    for (const auto& [vertex, weight] : row.terms) {
        if (vertex < 0 || vertex >= vertexCount)
            throw InputError("a constraint names vertex " + std::to_string(vertex) + ", but there are only " +
                             std::to_string(vertexCount));
        if (!std::isfinite(weight)) throw InputError("a constraint has a weight that is not a finite number");
        largest = std::max(largest, std::abs(weight));
    }
    if (largest == 0) throw InputError("a constraint has no weight");
}

bool sameTerms(const ConstraintRow& a, const ConstraintRow& b) {
    return a.terms == b.terms;
}

/// Returns whether factors of this material last.
template <int Dim>
bool mayReuse(const Material<Dim>& material) {
    return std::all_of(material.phi.begin(), material.phi.end(),
                       [](double phi) { return std::cos(phi) <= kStiffestReuse * std::sin(phi); });
}

/// Returns whether turning the factor helps, which it must for most of the cells.
template <int Dim>
bool mayTurn(const Material<Dim>& material) {
    const auto cells = std::count_if(material.phi.begin(), material.phi.end(), [](double phi) {
        return std::cos(phi) > kTurningRatio * std::sin(phi);
    });
    return 2 * cells > static_cast<std::ptrdiff_t>(material.phi.size());
}

}  // namespace

template <int Dim>
VelocitySolver<Dim>::Impl::Impl(std::shared_ptr<const SimplicialMesh<Dim>> mesh, const Material<Dim>& stuff,
                                const BackEndFactory<Dim>& makeBackEnd, int threads, SolverKind solver,
                                const IterativeSolverFactory<Dim>& makeMultigrid)
    : rest(std::move(mesh)),
      components(cellComponents(*rest)),
      material(stuff),
      reusable(mayReuse(material)),
      turns(mayTurn(material)) {
    const Stopwatch watch(statistics.analyze);
    const bool smoothing = material.smoothing.kind != SmoothingKind::None;
    const bool isDirect = solver == SolverKind::Direct;
    plan = std::make_shared<const AssemblyPlan<Dim>>(
        makeAssemblyPlan(*rest, smoothing, isDirect ? Contributions::Listed : Contributions::Left));
    if (isDirect)
        ownBackEnd = makeBackEnd(plan, *rest, material, threads);
    else
        multigrid = makeMultigrid({plan, rest, material, system, threads});
    backEnd = isDirect ? ownBackEnd.get() : &multigrid->backEnd();
    cache.emplace(*backEnd, system, statistics);
    if (!multigrid) return;
    statistics.needed = multigrid->needed();
    cache->useMultigrid(*multigrid);
}

/// Appends the welds, eliminates the rows, and drops everything that depends on the constraints. Equal rows
/// change nothing.
template <int Dim>
void VelocitySolver<Dim>::Impl::setConstraints(std::vector<ConstraintRow> newRows, Sliders newSliders) {
    for (const Weld& weld : rest->welds) newRows.push_back({weld.terms});
    newRows = simplified(newRows);
    if (constrained && newSliders == givenSliders &&
        std::equal(rows.begin(), rows.end(), newRows.begin(), newRows.end(), sameTerms))
        return;
    const Stopwatch watch(statistics.analyze);
    for (const auto& row : newRows) requireRow(row, rest->vertexCount());
    rows = std::move(newRows);
    givenSliders = std::move(newSliders);
    elimination = eliminate(rows, givenSliders);
    projection = Projection<Dim>(rows, elimination.dependent, rest->vertexCount());
    system = ReducedSystem<Dim>(*plan, elimination, givenSliders);

    const std::vector<ConstraintRow> given(rows.begin(),
                                           rows.end() - static_cast<std::ptrdiff_t>(rest->welds.size()));
    const auto held = wellConstrained(*rest, components, given, system.sliders());
    tracking.reset();
    descending.reset();
    massRegularization.clear();
    loose = looseGroups(*rest, components, held, given, system.sliders());
    if (std::find(held.begin(), held.end(), false) != held.end())
        for (int component : components)
            massRegularization.push_back(held[component] ? 0.0 : kMassRegularization);
    if (isMultigrid())
        multigrid->analyze(massRegularization);
    else
        backEnd->setMassRegularization(massRegularization);

    cache->reset(*plan);
    constrained = true;
    ++statistics.analyses;
}

/// Returns the values of all rows and sliders: a weld prescribes that its points keep their distance, which
/// is 0.
template <int Dim>
Points<Dim> VelocitySolver<Dim>::Impl::withWelds(const Points<Dim>& given) const {
    const auto welds = static_cast<Eigen::Index>(rest->welds.size()),
               first = static_cast<Eigen::Index>(rows.size()) - welds, sliding = given.cols() - first;
    Points<Dim> all = Points<Dim>::Zero(Dim, given.cols() + welds);
    all.leftCols(first) = given.leftCols(first);
    all.rightCols(sliding) = given.rightCols(sliding);
    return all;
}

template <int Dim>
bool VelocitySolver<Dim>::Impl::analyze() {
    if (!constrained) setConstraints({});
    const Stopwatch watch(statistics.analyze);
    return cache->analyze(stop);
}

template <int Dim>
bool VelocitySolver<Dim>::Impl::reuses() const {
    return isMultigrid() || (reusable && tolerance >= kMinTolerance);
}

template <int Dim>
typename FactorCache<Dim>::Use VelocitySolver<Dim>::Impl::use() const {
    using Use = typename FactorCache<Dim>::Use;
    return reuses() ? Use::Lasting : tolerance > 0 ? Use::Once : Use::OnceExact;
}

template <int Dim>
RestEnergy<Dim>& VelocitySolver<Dim>::Impl::rested() {
    if (!restEnergy) restEnergy.emplace(plan, *rest, material);
    return *restEnergy;
}

/// Returns the minimizer of W, with or without the proximal term.
template <int Dim>
RestMinimizer<Dim>& VelocitySolver<Dim>::Impl::minimizer() {
    if (!constrained) setConstraints({});
    if (proximal) {
        if (!descending)
            descending.emplace(*plan, rested(), system, massRegularization, backEnd->workers(), statistics);
        return *descending;
    }
    if (!tracking) {
        const Stopwatch watch(statistics.analyze);
        const auto own = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(*rest, false));
        tracking.reset(new Tracking{own,
                                    RestEnergy<Dim>(own, *rest, material),
                                    ReducedSystem<Dim>(*own, elimination, givenSliders),
                                    {}});
        tracking->system.setDirections(system.directions());
        tracking->minimizer.emplace(*own, tracking->energy, tracking->system, massRegularization,
                                    backEnd->workers(), statistics);
    }
    return *tracking->minimizer;
}

/// Sets the proximal term with A assembled at the origin; weight 0 removes it.
template <int Dim>
int VelocitySolver<Dim>::Impl::setProximal(double weight, const Points<Dim>& origin) {
    if (weight == 0) {
        proximal.reset();
        return -1;
    }
    const Stopwatch watch(statistics.assemble);
    if (!proximal) proximal.emplace();
    proximal->weight = weight;
    proximal->origin = origin;
    proximal->apply = [this](const Points<Dim>& v, Points<Dim>& Av) { backEnd->apply(v, Av); };
    if (const int cell = backEnd->setShape(origin); cell >= 0) return cell;
    proximal->blocks.resize(static_cast<std::size_t>(plan->blockCount()) * Dim * Dim);
    backEnd->assemble(proximal->blocks);
    return -1;
}

/// Computes f = ½ rate ∇W. E(v) + rate ⟨∇W, v⟩ is least where A v + ½ rate ∇W vanishes on all fields that the
/// constraints allow.
template <int Dim>
void VelocitySolver<Dim>::Impl::computeLoad() {
    load.resize(Dim, 0);
    if (memoryRate == 0) return;
    const Stopwatch watch(statistics.assemble);
    rested().gradient(*backEnd->stages().shape(), load, backEnd->workers());
    if (load.isZero(0))
        load.resize(Dim, 0);
    else
        load *= 0.5 * memoryRate;
}

/// Solves K y = −Zᵀ (A v + f) with v = v_p on entry, and adds Z y; again with the new residual while that is
/// large. Refinement costs a product and a pair of triangular solves, and recovers the digits that a factor
/// of an ill-conditioned matrix loses.
template <int Dim>
SolveOutcome VelocitySolver<Dim>::Impl::solveReduced(Points<Dim>& v) {
    const Stopwatch watch(statistics.solve);
    Points<Dim> Av, right, y;
    double first = 0;
    for (int i = 0; i <= kRefinements; ++i) {
        backEnd->apply(v, Av);
        if (loadOrNull()) Av += load;
        system.restrict(Av, right);
        right = -right;
        const double size = right.cwiseAbs().maxCoeff();
        if (i == 0) first = size;
        if (i > 0 && size <= kResidual * first) break;
        if (stop.stop_requested()) return {SolveOutcome::Kind::Stopped, -1};
        y.resize(Dim, right.cols());
        ++statistics.iterations;
        if (!cache->solve(flat<Dim>(right), flat<Dim>(y))) return {SolveOutcome::Kind::NotFinite, -1};
        system.release(y);
        system.expand(y, v);
    }
    return v.allFinite() ? SolveOutcome{} : SolveOutcome{SolveOutcome::Kind::NotFinite, -1};
}

template <int Dim>
void VelocitySolver<Dim>::Impl::turn(const Points<Dim>& from, const Points<Dim>& to,
                                     std::vector<Points<Dim>>& fields) {
    if (!fieldRotations) fieldRotations.emplace(*plan);
    fieldRotations->compute(from, to, backEnd->workers(), VertexRotations<Dim>::Finish::Rough);
    for (auto& field : fields) fieldRotations->turn(field);
}

/// Computes the rotations between the factor's shape and the current one, or one near it.
template <int Dim>
void VelocitySolver<Dim>::Impl::turnFactor() {
    const Nodal<Dim>& to = cache->turnedShape();
    if (turnedFrom == cache->shape() && turnedTo == to) return;
    if (!rotations) rotations.emplace(*plan);
    rotations->compute(*cache->shape(), *to, backEnd->workers());
    turnedFrom = cache->shape();
    turnedTo = to;
}

template <int Dim>
typename ConjugateGradients<Dim>::Result VelocitySolver<Dim>::Impl::iterateWithFactor(
    const typename ConjugateGradients<Dim>::Goal& goal, bool turned, Points<Dim>& v) {
    if (turned) turnFactor();
    const auto precondition = [&](std::span<const double> r, std::span<double> z) {
        if (!turned) return cache->solve(r, z);
        turnedRight.assign(r.begin(), r.end());
        rotations->turnBack(system.unknowns(), turnedRight);
        const bool done = cache->solve(turnedRight, z);
        rotations->turn(system.unknowns(), z);
        return done;
    };
    return iteration.run(*backEnd, system, precondition, goal, loadOrNull(), v);
}

/// Iterates by conjugate gradients with the current factor; returns false if a new one is the better choice.
template <int Dim>
bool VelocitySolver<Dim>::Impl::iterate(Points<Dim>& v) {
    const Stopwatch watch(statistics.solve);
    const double lag = cache->lag();
    // Sliding is along fixed directions.
    const bool turned = turns && lag > 0 && givenSliders.empty();
    typename ConjugateGradients<Dim>::Goal goal;
    goal.tolerance = isMultigrid() ? std::max(tolerance, kMultigridTolerance) : tolerance;
    goal.cautious = isMultigrid();
    if (isMultigrid()) goal.most = kMostWithMultigrid;
    goal.contraction = cache->expectedContraction(lag);
    goal.minContraction = cache->minContraction();
    if (lag == 0 && cache->isSingle()) goal.poorestContraction = kPoorestContraction;
    goal.stop = stop;
    if (progress) goal.progress = [this](double part) { progress(FieldWork::Iterations, part); };
    const RefactorPolicy& policy = cache->policy();
    goal.trials = policy.keepsPace() ? kTrials : 1;
    goal.hopeless = [&](double iterations) { return lag > 0 && policy.hopeless(iterations); };
    const auto result =
        isMultigrid() ? multigrid->run(goal, loadOrNull(), v) : iterateWithFactor(goal, turned, v);
    statistics.iterations += result.iterations;
    cache->learn(lag, result);
    return result.end == ConjugateGradients<Dim>::Result::End::Converged && v.allFinite();
}

/// Solves with a factor of this very shape; one in single precision is no longer enough then.
template <int Dim>
SolveOutcome VelocitySolver<Dim>::Impl::solveDirectly(Points<Dim>& v) {
    if (cache->improve())
        if (const auto outcome = cache->make(use(), stop); !outcome.done()) return outcome;
    return solveReduced(v);
}

/// Solves with a new factor: ahead of the shape, which moves by about `velocity`, or at the shape itself if
/// that one does not do. In order: a factor ahead of the shape, one at the shape, and with direct solvers one
/// in double precision with iterative refinement.
template <int Dim>
SolveOutcome VelocitySolver<Dim>::Impl::solveAnew(const Points<Dim>& prescribed, Points<Dim>& v,
                                                  const Points<Dim>* velocity) {
    if (const auto outcome = cache->make(use(), stop, velocity); !outcome.done()) return outcome;
    if (!v.allFinite()) system.particular(prescribed, v);
    if (reuses() && iterate(v)) return {};
    if (cache->isAhead()) return solveAnew(prescribed, v, nullptr);
    if (!isMultigrid()) return solveDirectly(v);
    return {stop.stop_requested() ? SolveOutcome::Kind::Stopped : SolveOutcome::Kind::NotConverged, -1};
}

/// Solves by the factor of an earlier shape if that is allowed and pays, else with a new one. The stages are:
/// set the shape, take v_p from the prescribed values, add the load of the memory, start from the guess's
/// free part, iterate with a factor that is there or make one. A field of no prescribed motion and no load is
/// 0 without any of it. `last` stays empty after a failure.
template <int Dim>
SolveOutcome VelocitySolver<Dim>::Impl::solve(const Points<Dim>& given, Points<Dim>& v,
                                              const std::optional<Points<Dim>>& guess) {
    if (!constrained) setConstraints({});
    const Points<Dim> prescribed = withWelds(given);
    last.resize(Dim, 0);
    if (!prescribed.allFinite()) return {SolveOutcome::Kind::NotFinite, -1};
    {
        const Stopwatch watch(statistics.assemble);
        if (const int cell = backEnd->setStage(); cell >= 0) return {SolveOutcome::Kind::CellInverted, cell};
    }
    system.particular(prescribed, v);
    computeLoad();
    if (v.isZero(0) && !loadOrNull()) return {};  // nothing moves
    if (!system.unknowns().empty()) {
        if (!analyze()) return {SolveOutcome::Kind::Stopped, -1};
        const bool guessed = reuses() && guess && guess->allFinite();
        if (guessed) system.adopt(*guess, v);
        const bool stale = reuses() && reusable && cache->restore(stop);
        if (!stale || !iterate(v))
            if (const auto outcome = solveAnew(prescribed, v, guessed ? &*guess : nullptr); !outcome.done())
                return outcome;
    }
    last = v;
    return {};
}

template struct VelocitySolver<2>::Impl;
template struct VelocitySolver<3>::Impl;

}  // namespace wend
