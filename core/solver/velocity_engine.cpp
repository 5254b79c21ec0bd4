#include "core/solver/velocity_engine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "core/mesh/error.h"
#include "core/solver/components.h"

namespace wend {
namespace {

// Weight of the mass matrix in parts with too few constraints: 1e-8 is off by 1 %, 1 by 2 % (docs/method.md
// (15), Constraints).
constexpr double kMassRegularization = 1e-4;
// Refine while the residual, relative to the right-hand side, is above this: only the stiffest materials need
// it.
constexpr double kResidual = 1e-10;
constexpr int kRefinements = 3;
// Below this iterations with a stale factor save nothing.
constexpr double kMinTolerance = 1e-8;
// Of an iteration with a factor of this very shape in double precision. In single the condition of the matrix
// decides: 0.02 with 11 000 vertices in the plane, 0.2 with 40 000, 0.6 with 160 000.
constexpr double kFreshContractionDouble = 1e-6;
constexpr double kBestContraction = 0.05;
// The same at the factor's own shape, where it was measured before: so many times what it was, and no less.
constexpr double kFreshMargin = 4, kBestFresh = 0.005;
// With a new factor the contraction grows with the distance about as it did with the last one.
constexpr double kCarriedMargin = 2;
// Above this, at its own shape, a factor in single precision costs more iterations than one in double would,
// and they show so little of the error that they would end too early.
constexpr double kPoorestContraction = 0.5;
constexpr int kTrials = 3;  // before a factor that is dear is given up
// Above this ratio w_r / w_q (EQUIA is 512) a factor does not last: hundreds of iterations.
constexpr double kStiffestReuse = 20;
// Above this ratio (METR is 2, AKVF 0) the factor is turned with the shape.
constexpr double kTurningRatio = 0.5;
// Minimum degree is quicker below and makes no more fill.
constexpr int kNestedDissectionVertices = 8000;

/// Adds the seconds of its life to a counter.
class Stopwatch {
  public:
    explicit Stopwatch(double& seconds) : m_seconds(seconds), m_start(std::chrono::steady_clock::now()) {}
    ~Stopwatch() {
        m_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& m_seconds;
    std::chrono::steady_clock::time_point m_start;
};

template <int Dim>
std::span<double> flat(Points<Dim>& points) {
    return {points.data(), static_cast<std::size_t>(points.size())};
}

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

Sliders withoutPivots(Sliders sliders, const Elimination& elimination) {
    std::set<int> pivots;
    for (const auto& pivot : elimination.pivots) pivots.insert(pivot.vertex);
    std::erase_if(sliders, [&](const auto& slider) { return pivots.contains(slider.first); });
    return sliders;
}

/// Whether factors of this material last.
template <int Dim>
bool mayReuse(const Material<Dim>& material) {
    return std::all_of(material.phi.begin(), material.phi.end(),
                       [](double phi) { return std::cos(phi) <= kStiffestReuse * std::sin(phi); });
}

/// Whether turning the factor helps: for most of the cells.
template <int Dim>
bool mayTurn(const Material<Dim>& material) {
    const auto cells = std::count_if(material.phi.begin(), material.phi.end(), [](double phi) {
        return std::cos(phi) > kTurningRatio * std::sin(phi);
    });
    return 2 * cells > static_cast<std::ptrdiff_t>(material.phi.size());
}

}  // namespace

template <int Dim>
VelocitySolver<Dim>::Engine::Engine(std::shared_ptr<const SimplicialMesh<Dim>> mesh,
                                    const Material<Dim>& stuff, const BackEndFactory<Dim>& makeBackEnd,
                                    int threads)
    : rest(std::move(mesh)),
      components(cellComponents(*rest)),
      material(stuff),
      reusable(mayReuse(material)),
      turns(mayTurn(material)) {
    const Stopwatch watch(statistics.analyze);
    const bool smoothing = material.smoothing.kind != SmoothingKind::None;
    plan = std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(*rest, smoothing));
    backEnd = makeBackEnd(plan, *rest, material, threads);
    blocks.resize(static_cast<std::size_t>(plan->blockCount()) * Dim * Dim);
}

template <int Dim>
void VelocitySolver<Dim>::Engine::setConstraints(std::vector<ConstraintRow> newRows, Sliders newSliders) {
    newRows = simplified(newRows);
    if (analyzed && newSliders == givenSliders &&
        std::equal(rows.begin(), rows.end(), newRows.begin(), newRows.end(), sameTerms))
        return;
    const Stopwatch watch(statistics.analyze);
    for (const auto& row : newRows) requireRow(row, rest->vertexCount());
    rows = std::move(newRows);
    givenSliders = std::move(newSliders);
    elimination = eliminate(rows, givenSliders);
    sliders = withoutPivots(givenSliders, elimination);
    projection = Projection<Dim>(rows, elimination.dependent, rest->vertexCount());
    system = ReducedSystem<Dim>(*plan, elimination, sliders);

    const auto constrained = wellConstrained(*rest, components, rows, sliders);
    std::vector<double> massRegularization;
    if (std::find(constrained.begin(), constrained.end(), false) != constrained.end())
        for (int component : components)
            massRegularization.push_back(constrained[component] ? 0.0 : kMassRegularization);
    backEnd->setMassRegularization(std::move(massRegularization));

    const bool small = Dim == 2 && system.unknowns().size() < kNestedDissectionVertices;
    if (!system.unknowns().empty())
        cholesky.analyze(system.columnStart(), system.row(), Dim,
                         small ? Ordering::MinimumDegree : Ordering::NestedDissection);
    countCosts();
    singleFactor.reset();
    doubleFactor.reset();
    held.reset();
    memory = {};
    analyzed = true;
    ++statistics.analyses;
}

template <int Dim>
bool VelocitySolver<Dim>::Engine::reuses() const {
    return reusable && tolerance >= kMinTolerance;
}

template <int Dim>
void VelocitySolver<Dim>::Engine::countCosts() {
    SolverCost cost;
    cost.factorFlops = cholesky.factorFlops();
    cost.factorEntries = cholesky.factorEntries();
    cost.contributions = static_cast<double>(plan->own.size() + plan->cross.size());
    cost.cells = plan->cellCount();
    cost.dimension = Dim;
    policy.setCosts(cost.factor(), cost.iteration());
}

template <int Dim>
bool VelocitySolver<Dim>::Engine::solveWithFactor(std::span<const double> b, std::span<double> x) {
    switch (heldKind) {
        case FactorKind::Single:
            return singleFactor->solve(b, x, backEnd->workers());
        case FactorKind::Double:
            return doubleFactor->solve(b, x, backEnd->workers());
        case FactorKind::Reference:
            break;
    }
    return cholesky.solve(b, x) == Cholesky::Status::Done;
}

template <int Dim>
bool VelocitySolver<Dim>::Engine::precondition(std::span<const double> r, std::span<double> z) {
    if (!turned) return solveWithFactor(r, z);
    turnedRight.assign(r.begin(), r.end());
    rotations->turnBack(system.unknowns(), turnedRight);
    const bool done = solveWithFactor(turnedRight, z);
    rotations->turn(system.unknowns(), z);
    return done;
}

/// A factor of our own, of the values that are there; false if a pivot is lost.
template <int Dim>
bool VelocitySolver<Dim>::Engine::factorizes(FactorKind kind) {
    const auto made = [&](auto& factor) {
        if (!factor) factor.emplace(cholesky.supernodes(), system.columnStart(), system.row());
        return factor->factorize(cholesky.values(), backEnd->workers(), stop);
    };
    if (kind == FactorKind::Single) {
        doubleFactor.reset();  // a factor is most of the memory: never two
        return made(singleFactor);
    }
    singleFactor.reset();
    return made(doubleFactor);
}

/// The back end is at that shape; null if the factor shall serve but once. Where a factor loses a pivot, the
/// next better one is tried.
template <int Dim>
SolveOutcome VelocitySolver<Dim>::Engine::factorizeAt(const Nodal<Dim>& shape, FactorKind kind) {
    const auto stopped = [&] { return stop.stop_requested(); };
    held.reset();
    if (stopped()) return {SolveOutcome::Kind::Stopped, -1};
    {
        const Stopwatch watch(statistics.assemble);
        backEnd->assemble(blocks);
        system.gather(blocks, cholesky.values());
    }
    const Stopwatch watch(statistics.factor);
    ++statistics.factorizations;
    auto status = Cholesky::Status::Done;
    heldKind = kind;
    if (heldKind == FactorKind::Single && !factorizes(heldKind) && !stopped()) heldKind = FactorKind::Double;
    if (heldKind == FactorKind::Double && !factorizes(heldKind) && !stopped())
        heldKind = FactorKind::Reference;
    if (heldKind == FactorKind::Reference) status = cholesky.factorize();
    if (stopped()) return {SolveOutcome::Kind::Stopped, -1};
    if (status == Cholesky::Status::NotFinite) return {SolveOutcome::Kind::NotFinite, -1};
    if (status != Cholesky::Status::Done) return {SolveOutcome::Kind::NotPositiveDefinite, -1};
    held = shape;
    return {};
}

template <int Dim>
SolveOutcome VelocitySolver<Dim>::Engine::factorize() {
    const bool iterates = reuses();
    const auto kind = iterates        ? memory.best
                      : tolerance > 0 ? std::max(memory.best, FactorKind::Double)
                                      : FactorKind::Reference;
    const SolveOutcome outcome = factorizeAt(iterates ? backEnd->stages().shape() : nullptr, kind);
    if (outcome.kind == SolveOutcome::Kind::Stopped) return outcome;
    memory.shape = held;
    memory.kind = heldKind;
    if (tolerance > 0) memory.best = heldKind;
    if (memory.contraction) *memory.contraction *= kCarriedMargin;
    policy.factorized();
    return outcome;
}

/// The factor of the memory, if another was made since. False if it cannot be had, as with other constraints.
template <int Dim>
bool VelocitySolver<Dim>::Engine::makeFactorAgain() {
    if (held == memory.shape && heldKind == memory.kind) return true;
    const bool done = backEnd->setShape(*memory.shape) < 0 && factorizeAt(memory.shape, memory.kind).done();
    backEnd->setStage();
    return done;
}

template <int Dim>
RestEnergy<Dim>& VelocitySolver<Dim>::Engine::rested() {
    if (!restEnergy) restEnergy.emplace(plan, *rest, material);
    return *restEnergy;
}

/// E(v) + rate ⟨∇W, v⟩ is least where A v + ½ rate ∇W vanishes on all fields that the constraints allow.
template <int Dim>
void VelocitySolver<Dim>::Engine::computeLoad() {
    load.resize(Dim, 0);
    if (memoryRate == 0) return;
    const Stopwatch watch(statistics.assemble);
    rested().gradient(*backEnd->stages().shape(), load, backEnd->workers());
    if (load.isZero(0))
        load.resize(Dim, 0);
    else
        load *= 0.5 * memoryRate;
}

/// v = v_p on entry. Solves K y = −Zᵀ (A v + f) and adds Z y; again with the new residual while that is
/// large.
template <int Dim>
SolveOutcome VelocitySolver<Dim>::Engine::solveReduced(Points<Dim>& v) {
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
        if (!solveWithFactor(flat<Dim>(right), flat<Dim>(y))) return {SolveOutcome::Kind::NotFinite, -1};
        system.expand(y, v);
    }
    return v.allFinite() ? SolveOutcome{} : SolveOutcome{SolveOutcome::Kind::NotFinite, -1};
}

/// The contraction of the first iteration cannot be measured within it. At the factor's own shape it is what
/// single precision left of the matrix, measured at the last chance; farther away it is taken to grow with
/// the distance, as it did with the factor before. What is not known is taken to be 1, so that there is a
/// second iteration, which measures it.
template <int Dim>
double VelocitySolver<Dim>::Engine::expectedContraction(double lag) const {
    const double fresh = memory.kind == FactorKind::Single
                             ? std::clamp(kFreshMargin * memory.freshContraction.value_or(1), kBestFresh, 1.0)
                             : kFreshContractionDouble;
    if (lag == 0) return fresh;
    if (memory.contraction.value_or(1) >= 1) return 1;
    const double there = std::max(minContraction(), *memory.contraction);
    return std::min(1.0, std::max(fresh, there * lag / memory.contractionLag));
}

/// A single lucky step is not believed: the next one is expected to gain a factor of 20 at most, and less
/// with a factor that is known to be poor.
template <int Dim>
double VelocitySolver<Dim>::Engine::minContraction() const {
    const bool single = memory.kind == FactorKind::Single;
    return std::max(kBestContraction, single ? memory.freshContraction.value_or(0) : 0.0);
}

template <int Dim>
void VelocitySolver<Dim>::Engine::learnContraction(double lag,
                                                   const typename ConjugateGradients<Dim>::Result& result) {
    if (!result.firstContraction) return;
    if (lag > 0) {
        memory.contraction = result.firstContraction;
        memory.contractionLag = lag;
    } else if (memory.kind == FactorKind::Single) {
        memory.freshContraction = result.worstContraction;
    }
}

/// Conjugate gradients with the factor at hand; false if a new one is the better way.
template <int Dim>
bool VelocitySolver<Dim>::Engine::iterate(Points<Dim>& v) {
    const Stopwatch watch(statistics.solve);
    const double lag = backEnd->stages().distance(memory.shape);
    turned = turns && lag > 0 && sliders.empty();  // sliding is along fixed directions
    if (turned) {
        if (!rotations) rotations.emplace(*plan);
        rotations->compute(*memory.shape, *backEnd->stages().shape(), backEnd->workers());
    }
    typename ConjugateGradients<Dim>::Goal goal;
    goal.tolerance = tolerance;
    goal.contraction = expectedContraction(lag);
    goal.minContraction = minContraction();
    if (lag == 0 && memory.kind == FactorKind::Single) goal.poorestContraction = kPoorestContraction;
    goal.stop = stop;
    goal.trials = policy.keepsPace() ? kTrials : 1;
    goal.hopeless = [&](double iterations) { return lag > 0 && policy.hopeless(iterations); };
    const auto result = iteration.run(
        *backEnd, system, [&](std::span<const double> r, std::span<double> z) { return precondition(r, z); },
        goal, loadOrNull(), v);
    statistics.iterations += result.iterations;
    policy.evaluated(result.iterations);
    learnContraction(lag, result);
    return result.end == ConjugateGradients<Dim>::Result::End::Converged && v.allFinite();
}

/// With a factor of this very shape; one in single precision is no longer enough then.
template <int Dim>
SolveOutcome VelocitySolver<Dim>::Engine::solveDirectly(Points<Dim>& v) {
    if (heldKind == FactorKind::Single) {
        memory.best = FactorKind::Double;
        if (const auto outcome = factorize(); !outcome.done()) return outcome;
    }
    return solveReduced(v);
}

template <int Dim>
SolveOutcome VelocitySolver<Dim>::Engine::solve(const Points<Dim>& prescribed, Points<Dim>& v,
                                                const std::optional<Points<Dim>>& guess) {
    if (!analyzed) setConstraints({});
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
        const bool iterates = reuses();
        if (iterates && guess && guess->allFinite()) system.adopt(*guess, v);
        const bool stale = iterates && memory.shape && !policy.due() && makeFactorAgain();
        if (!stale || !iterate(v)) {
            if (const auto outcome = factorize(); !outcome.done()) return outcome;
            if (!v.allFinite()) system.particular(prescribed, v);
            if (!iterates || !iterate(v))
                if (const auto outcome = solveDirectly(v); !outcome.done()) return outcome;
        }
    }
    last = v;
    return {};
}

template struct VelocitySolver<2>::Engine;
template struct VelocitySolver<3>::Engine;

}  // namespace wend
