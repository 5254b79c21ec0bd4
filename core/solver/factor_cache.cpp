#include "core/solver/factor_cache.h"

#include <algorithm>

#include "core/solver/stopwatch.h"

namespace wend {
namespace {

// The contraction of an iteration with a factor of this very shape in double precision. In single precision
// the condition of the matrix decides: 0.02 with 11 000 vertices in the plane, 0.2 with 40 000, 0.6 with 160
// 000.
constexpr double kFreshContractionDouble = 1e-6;
constexpr double kBestContraction = 0.05;
// The same at the factor's own shape, where it was measured before: so many times what it was, and no less.
constexpr double kFreshMargin = 4, kBestFresh = 0.005;
// With a new factor the contraction grows with the distance about as it did with the last one.
constexpr double kCarriedMargin = 2;
// A new factor is made this far ahead of the shape, as a part of the distance over which the last one served,
// and no farther, because a shape that turns is stretched along straight lines. Fewer than this many solves
// define no path.
constexpr double kAhead = 0.4, kFarthest = 0.15;
constexpr int kWay = 4;
// Cells that would fold over at this multiple of the distance would be too thin at its end; a factor made
// there would be blind to what they resist.
constexpr double kUnfolded = 3;
// Nearer than this part of where the contraction was measured it is not expected to be better: a factor that
// was made ahead is never quite met.
constexpr double kNearest = 0.5;
// The rotations of a shape serve for others that are nearer to it than this part of the distance from the
// factor's.
constexpr double kTurnedAgain = 0.2;
// Making the levels of multigrid takes about as long as this many iterations with them (docs/scale.md).
constexpr double kMultigridSetUp = 18;

/// Returns whether every cell has the same orientation in both shapes.
template <int Dim>
bool noneFolds(const std::vector<Cell<Dim>>& cells, const Points<Dim>& from, const Points<Dim>& to) {
    return std::all_of(cells.begin(), cells.end(), [&](const Cell<Dim>& cell) {
        return cellMeasure<Dim>(from, cell) * cellMeasure<Dim>(to, cell) > 0;
    });
}

}  // namespace

template <int Dim>
void FactorCache<Dim>::reset(const AssemblyPlan<Dim>& plan) {
    m_plan = &plan;
    m_analyzed = false;
    m_shape.reset();
    m_memory = {};
    m_policy.setCounts({});
}

/// Analyzes by minimum degree or nested dissection, depending on the size of the system, and sets the costs
/// of the policy. The costs are counted operations of the analysis, so that the policy decides the same in
/// every run.
template <int Dim>
bool FactorCache<Dim>::analyze(const std::stop_token& stop) {
    if (m_analyzed) return true;
    if (m_multigrid) {
        m_policy.setCosts(kMultigridSetUp, 1);
        return m_analyzed = true;
    }
    const AssemblyPlan<Dim>& plan = *m_plan;
    if (!m_system.unknowns().empty() && !m_factor.analyze(m_system.columnStart(), m_system.row(), Dim,
                                                          orderingFor(Dim, m_system.unknowns().size()), stop))
        return false;
    SolverCost cost;
    cost.factorFlops = m_factor.flops();
    cost.factorEntries = m_factor.entries();
    cost.contributions = static_cast<double>(plan.own.size() + plan.cross.size());
    cost.cells = plan.cellCount();
    cost.dimension = Dim;
    m_policy.setCosts(cost.factor(), cost.iteration());
    m_blocks.resize(static_cast<std::size_t>(plan.blockCount()) * Dim * Dim);
    return m_analyzed = true;
}

template <int Dim>
FactorMemory<Dim> FactorCache<Dim>::remember() const {
    FactorMemory<Dim> memory = m_memory;
    memory.counts = m_policy.counts();
    return memory;
}

template <int Dim>
void FactorCache<Dim>::recall(const FactorMemory<Dim>& memory) {
    m_memory = memory;
    m_policy.setCounts(memory.counts);
}

template <int Dim>
std::function<void(double)> FactorCache<Dim>::progressOf(FieldWork work) const {
    if (!m_progress) return {};
    return [this, work](double part) { m_progress(work, part); };
}

template <int Dim>
Factor::Status FactorCache<Dim>::makeFactor(FactorKind kind, const std::stop_token& stop) {
    {
        const Stopwatch watch(m_statistics.assemble);
        m_backEnd.assemble(m_blocks);
        m_system.gather(m_blocks, m_factor.values());
    }
    const Stopwatch watch(m_statistics.factor);
    const Factor::Status status =
        m_factor.factorize(kind, m_backEnd.workers(), stop, progressOf(FieldWork::Factor));
    m_analyzed = m_factor.isAnalyzed();
    m_statistics.needed = std::max(m_statistics.needed, m_factor.needed());
    return status;
}

/// Builds the levels of multigrid. The back end is at that shape.
template <int Dim>
Factor::Status FactorCache<Dim>::makeLevels(const Nodal<Dim>& shape, const std::stop_token& stop) {
    const Stopwatch watch(m_statistics.factor);
    switch (m_multigrid->build(shape, stop, progressOf(FieldWork::Levels))) {
        case BuildStatus::Stopped:
            return Factor::Status::Stopped;
        case BuildStatus::NotPositiveDefinite:
            return Factor::Status::NotPositiveDefinite;
        case BuildStatus::Done:
            break;
    }
    return Factor::Status::Done;
}

/// Makes a factor or the levels of multigrid. The back end is at that shape, which is null if the factor is
/// to serve only once.
template <int Dim>
SolveOutcome FactorCache<Dim>::factorize(const Nodal<Dim>& shape, FactorKind kind,
                                         const std::stop_token& stop) {
    m_shape.reset();
    if (stop.stop_requested()) return {SolveOutcome::Kind::Stopped, -1};
    ++m_statistics.factorizations;
    switch (m_multigrid ? makeLevels(shape, stop) : makeFactor(kind, stop)) {
        case Factor::Status::Stopped:
            return {SolveOutcome::Kind::Stopped, -1};
        case Factor::Status::NotFinite:
            return {SolveOutcome::Kind::NotFinite, -1};
        case Factor::Status::NotPositiveDefinite:  // with multigrid it is only its levels
            return {m_multigrid ? SolveOutcome::Kind::NotConverged : SolveOutcome::Kind::NotPositiveDefinite,
                    -1};
        case Factor::Status::Done:
            break;
    }
    m_shape = shape;
    return {};
}

/// Brings the back end to where the shape will be when the new factor has served for a while: along its
/// present velocity, by kAhead of the distance over which the last factor served. A factor in the middle of
/// the path is half as far from both ends as one at its beginning. Returns null, with the back end where it
/// was, if the last factor served too few solves to tell that distance, or if cells would soon fold over.
template <int Dim>
Nodal<Dim> FactorCache<Dim>::goAhead(const Points<Dim>& velocity) {
    const double distance = std::min(kFarthest, kAhead * (m_memory.ahead + m_memory.lag)),
                 speed = velocity.cwiseAbs().maxCoeff();
    if (m_policy.counts().evaluations < kWay || !(distance > 0 && speed > 0)) return nullptr;
    const Points<Dim> way = distance / speed * velocity;
    const Nodal<Dim> here = m_backEnd.stages().shape();
    auto shape = std::make_shared<const Points<Dim>>(*here + way);
    if (!noneFolds<Dim>(m_plan->cells, *here, *here + kUnfolded * way)) return nullptr;
    if (m_backEnd.setShape(*shape) < 0) {
        m_memory.ahead = distance;
        return shape;
    }
    m_backEnd.setStage();
    return nullptr;
}

template <int Dim>
SolveOutcome FactorCache<Dim>::make(Use use, const std::stop_token& stop, const Points<Dim>* velocity) {
    const bool lasts = use == Use::Lasting, exact = use == Use::OnceExact;
    const auto own = lasts ? m_memory.best : std::max(m_memory.best, FactorKind::Double);
    const auto kind = exact ? FactorKind::Reference : m_factor.quickest(own);
    const Nodal<Dim> ahead = lasts && velocity ? goAhead(*velocity) : nullptr;
    if (!ahead) m_memory.ahead = 0;
    const SolveOutcome outcome = factorize(ahead || !lasts ? ahead : m_backEnd.stages().shape(), kind, stop);
    // The back end returns to the shape that is to be solved for.
    if (ahead) m_backEnd.setStage();
    if (outcome.kind == SolveOutcome::Kind::Stopped) return outcome;
    m_memory.shape = m_shape;
    m_memory.directions = m_system.directions();
    m_memory.turned = nullptr;
    m_memory.kind = this->kind();
    if (!exact) m_memory.best = this->kind();
    if (m_memory.contraction) *m_memory.contraction *= kCarriedMargin;
    m_policy.factorized();
    return outcome;
}

template <int Dim>
bool FactorCache<Dim>::restore(const std::stop_token& stop) {
    if (!m_memory.shape || m_policy.due()) return false;
    if (m_shape == m_memory.shape && kind() == m_memory.kind) return true;
    const Nodal<Dim> directions = m_system.setDirections(m_memory.directions);
    const bool done =
        m_backEnd.setShape(*m_memory.shape) < 0 && factorize(m_memory.shape, m_memory.kind, stop).done();
    m_system.setDirections(directions);
    m_backEnd.setStage();
    return done;
}

template <int Dim>
bool FactorCache<Dim>::improve() {
    if (!isSingle()) return false;
    m_memory.best = FactorKind::Double;
    return true;
}

/// Stages of a step come in pairs that hardly differ: at its middle, and at its end, where the next one
/// begins.
template <int Dim>
const Nodal<Dim>& FactorCache<Dim>::turnedShape() {
    auto& stages = m_backEnd.stages();
    if (!m_memory.turned || stages.distance(m_memory.turned) > kTurnedAgain * m_memory.lag)
        m_memory.turned = stages.shape();
    return m_memory.turned;
}

/// Estimates the contraction of the first iteration, which cannot be measured within it. At the factor's own
/// shape it is what single precision has left of the matrix, measured at the last opportunity; farther away
/// it is taken to grow with the distance, as it did with the factor before. An unknown contraction is taken
/// to be 1, so that there is a second iteration, which measures it.
template <int Dim>
double FactorCache<Dim>::expectedContraction(double lag) const {
    const double fresh =
        isRough() ? std::clamp(kFreshMargin * m_memory.freshContraction.value_or(1), kBestFresh, 1.0)
                  : kFreshContractionDouble;
    if (lag == 0) return fresh;
    if (m_memory.contraction.value_or(1) >= 1) return 1;
    const double there = std::max(minContraction(), *m_memory.contraction);
    return std::min(1.0, std::max(fresh, there * std::max(kNearest, lag / m_memory.contractionLag)));
}

/// A single lucky step is not believed: the next one is expected to gain a factor of 20 at most, and less
/// with a factor that is known to be poor.
template <int Dim>
double FactorCache<Dim>::minContraction() const {
    return std::max(kBestContraction, isSingle() ? m_memory.freshContraction.value_or(0) : 0.0);
}

template <int Dim>
void FactorCache<Dim>::learn(double lag, const typename ConjugateGradients<Dim>::Result& result) {
    m_policy.evaluated(result.iterations);
    if (!result.firstContraction) return;
    if (lag > 0) {
        m_memory.contraction = result.firstContraction;
        m_memory.contractionLag = lag;
    } else if (isRough()) {
        m_memory.freshContraction = result.worstContraction;
    }
}

template class FactorCache<2>;
template class FactorCache<3>;

}  // namespace wend
