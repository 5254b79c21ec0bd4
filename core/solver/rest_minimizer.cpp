#include "core/solver/rest_minimizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/solver/flat_points.h"
#include "core/solver/stopwatch.h"

namespace wend {
namespace {

constexpr double kArmijo = 1e-4;
// Parts of the negative curvature that factors have, in the order of trial.
constexpr std::array<double, 3> kNegative = {1, 0.9, 0};
constexpr int kMostHalvings = 30;
// A step may take this part of the path to the first flat cell.
constexpr double kBeforeFlat = 0.8;
// The exact Hessian was indefinite: so many steps later it is tried again.
constexpr int kSteps = 2;
// W is a sum of many terms: differences below this part of it are rounding.
constexpr double kRounding = 1e-13;
// A gradient of this norm is rounding: forces are of the order of 1.
constexpr double kNoForce = 1e-14;
// The shape is moved off a saddle by this much, in sizes. A saddle is near where the exact Hessian is
// indefinite, steps are no longer than the second number, and they promise no more than this part of W.
constexpr double kNudge = 1e-3, kNearSaddle = 1e-9;
constexpr int kMostNudges = 3;
// In a live drag a factor serves again while each step is shorter than this part of the one before.
constexpr double kQuickly = 0.4;
// Otherwise an exact one serves while steps are shorter than the first number, in sizes, and than the second
// part of the one before. What is expected to be left after the last step with it is less than the third part
// of the tolerance; after a step with a factor of its own it is about the square.
constexpr double kNearby = 1e-3, kVeryQuickly = 0.1, kLeft = 1e-6;
// Errors of predict(): in sizes, and relative to the step. It ends after so many iterations, and then makes
// a new factor, which is expected to leave a hundredth of the error at first.
constexpr double kPredicted = 2e-5, kOfStep = 0.01;
constexpr int kMostPredicting = 12;
constexpr double kFreshContraction = 0.01;

}  // namespace

template <int Dim>
RestMinimizer<Dim>::RestMinimizer(const AssemblyPlan<Dim>& plan, RestEnergy<Dim>& energy,
                                  ReducedSystem<Dim>& system, const std::vector<double>& massRegularization,
                                  WorkerPool& workers, SolverStatistics& statistics)
    : m_plan(plan), m_energy(energy), m_system(system), m_workers(workers), m_statistics(statistics) {
    if (massRegularization.empty()) return;
    m_mass.assign(static_cast<std::size_t>(plan.vertexCount), 0);
    for (int c = 0; c < plan.cellCount(); ++c)
        for (const int vertex : plan.cells[c])
            m_mass[vertex] += massRegularization[c] * energy.measure(c) / (Dim + 1);
}

/// Assembles and factorizes the Hessian with a part of the cells' negative curvature.
template <int Dim>
SolveOutcome RestMinimizer<Dim>::factorizeAs(double negative, FactorKind kind, const Points<Dim>& shape,
                                             const ProximalTerm<Dim>* proximal, const std::stop_token& stop) {
    {
        const Stopwatch watch(m_statistics.assemble);
        m_energy.linearize(shape, negative, m_workers);
        if (proximal) {
            m_blocks.resize(proximal->blocks.size());
            std::ranges::transform(proximal->blocks, m_blocks.begin(),
                                   [&](double value) { return 2 * proximal->weight * value; });
        } else {
            m_blocks.assign(static_cast<std::size_t>(m_plan.blockCount()) * Dim * Dim, 0);
        }
        m_energy.addHessian(m_blocks, m_workers);
        for (std::size_t v = 0; v < m_mass.size(); ++v)  // the diagonal block is the first of its column
            for (int k = 0; k < Dim; ++k)
                m_blocks[static_cast<std::size_t>(m_plan.columnStart[v]) * Dim * Dim + k * (Dim + 1)] +=
                    m_mass[v];
        m_system.gather(m_blocks, m_factor.values());
    }
    const Stopwatch watch(m_statistics.factor);
    ++m_statistics.factorizations;
    m_isMade = false;
    const auto status = m_factor.factorize(m_factor.quickest(kind), m_workers, stop);
    m_statistics.needed = std::max(m_statistics.needed, m_factor.needed());
    switch (status) {
        case Factor::Status::Stopped:
            return {SolveOutcome::Kind::Stopped, -1};
        case Factor::Status::NotFinite:
            return {SolveOutcome::Kind::NotFinite, -1};
        case Factor::Status::NotPositiveDefinite:
            return {SolveOutcome::Kind::NotPositiveDefinite, -1};
        case Factor::Status::Done:
            break;
    }
    m_isMade = true;
    m_policy.factorized();
    m_contraction = kFreshContraction;
    return {};
}

/// Factorizes the exact Hessian if that is positive definite, else one with as much of its negative curvature
/// as possible: where a shape is about to buckle most of it is, and steps are long.
template <int Dim>
SolveOutcome RestMinimizer<Dim>::factorize(FactorKind kind, const Points<Dim>& shape,
                                           const ProximalTerm<Dim>* proximal, const std::stop_token& stop) {
    if (!m_factor.isAnalyzed()) {
        const Stopwatch watch(m_statistics.analyze);
        if (!m_factor.analyze(m_system.columnStart(), m_system.row(), Dim,
                              orderingFor(Dim, m_system.unknowns().size()), stop))
            return {SolveOutcome::Kind::Stopped, -1};
        const SolverCost cost{m_factor.flops(), m_factor.entries(), static_cast<double>(m_plan.own.size()),
                              static_cast<double>(m_plan.cellCount()), Dim};
        m_policy.setCosts(cost.factor(), cost.iteration());
    }
    std::size_t level = m_untilExact == 0 ? 0 : std::max<std::size_t>(m_level, 1);
    m_untilExact = std::max(m_untilExact - 1, 0);
    for (;; ++level) {
        const SolveOutcome outcome = factorizeAs(kNegative[level], kind, shape, proximal, stop);
        m_level = level;
        m_isExact = level == 0;
        if (outcome.kind != SolveOutcome::Kind::NotPositiveDefinite || level + 1 == kNegative.size())
            return outcome;
        m_untilExact = kSteps;
    }
}

template <int Dim>
double RestMinimizer<Dim>::value(const Points<Dim>& shape, const ProximalTerm<Dim>* proximal) const {
    double sum = m_energy.energy(shape);
    if (!proximal || !std::isfinite(sum)) return sum;
    Points<Dim> Av;
    const Points<Dim> v = shape - proximal->origin;
    proximal->apply(v, Av);
    return sum + proximal->weight * v.cwiseProduct(Av).sum();
}

/// Computes the gradient and its reduction to the unknowns, whose norm it returns.
template <int Dim>
double RestMinimizer<Dim>::slope(const Points<Dim>& shape, const ProximalTerm<Dim>* proximal) {
    m_energy.gradient(shape, m_gradient, m_workers);
    if (proximal) {
        Points<Dim> Av;
        proximal->apply(shape - proximal->origin, Av);
        m_gradient += 2 * proximal->weight * Av;
    }
    m_system.restrict(m_gradient, m_reduced);
    return m_reduced.norm();
}

/// Computes Zᵀ H v of the Hessian that was computed last.
template <int Dim>
void RestMinimizer<Dim>::product(const Points<Dim>& v, const ProximalTerm<Dim>* proximal,
                                 Points<Dim>& reduced) {
    Points<Dim> Hv;
    m_energy.applyHessian(v, Hv, m_workers);
    if (proximal) {
        Points<Dim> Av;
        proximal->apply(v, Av);
        Hv += 2 * proximal->weight * Av;
    }
    m_system.restrict(Hv, reduced);
}

/// Adds Z y to the step such that Zᵀ H step = −Zᵀ g, by conjugate gradients with the factor that there is.
/// Returns false if they end too late or meet negative curvature. The error after an iteration is estimated
/// as in ConjugateGradients, |z| ρ / (1 − ρ) with the last contraction ρ.
template <int Dim>
bool RestMinimizer<Dim>::iterate(const ProximalTerm<Dim>* proximal, Points<Dim>& step) {
    const Stopwatch watch(m_statistics.solve);
    product(step, proximal, m_r);
    m_r = -(m_r + m_reduced);
    m_z.resizeLike(m_r);
    double before = 0, rzBefore = 0, contraction = m_contraction;
    for (int k = 0; k < kMostPredicting; ++k) {
        ++m_statistics.iterations;
        if (!m_factor.solve(flat<Dim>(m_r), flat<Dim>(m_z), m_workers)) return false;
        m_system.release(m_z);
        const double size = m_z.cwiseAbs().maxCoeff(), rz = m_r.cwiseProduct(m_z).sum();
        if (size == 0) return true;
        if (k > 0) contraction = size / before;
        if (k == 1) m_contraction = contraction;
        if (k == 0)
            m_p = m_z;
        else
            m_p = m_z + rz / rzBefore * m_p;
        m_lifted.setZero(Dim, step.cols());
        m_system.expand(m_p, m_lifted);
        product(m_lifted, proximal, m_product);
        const double pHp = m_p.cwiseProduct(m_product).sum();
        if (!(pHp > 0 && rz > 0)) return false;
        step += rz / pHp * m_lifted;
        const double allowed = std::max(kPredicted, kOfStep * step.cwiseAbs().maxCoeff());
        if (contraction < 1 && size * contraction / (1 - contraction) <= allowed) {
            m_policy.evaluated(k + 1);
            return step.allFinite();
        }
        m_r -= rz / pHp * m_product;
        before = size;
        rzBefore = rz;
    }
    return false;
}

/// Takes the step with the factor of an earlier shape, if there is one and a new one does not pay.
template <int Dim>
bool RestMinimizer<Dim>::reuse(const Points<Dim>& shape, const ProximalTerm<Dim>* proximal,
                               Points<Dim>& step) {
    if (!m_isMade || m_policy.due()) return false;
    {
        const Stopwatch watch(m_statistics.assemble);
        m_energy.linearize(shape, kNegative[m_level], m_workers);
    }
    return iterate(proximal, step);
}

/// Makes a factor of the very shape and solves with it; iterates first if one from before may serve.
template <int Dim>
SolveOutcome RestMinimizer<Dim>::predict(Pace pace, const Points<Dim>& shape, const Points<Dim>& prescribed,
                                         const ProximalTerm<Dim>* proximal, const std::stop_token& stop,
                                         Points<Dim>& step) {
    m_system.particular(prescribed, step);
    if (m_system.unknowns().empty()) return {};
    slope(shape, proximal);
    if (pace == Pace::Even) {
        const Points<Dim> particular = step;
        if (reuse(shape, proximal, step)) return {};
        step = particular;
        const SolveOutcome outcome = factorize(FactorKind::Single, shape, proximal, stop);
        if (!outcome.done() || iterate(proximal, step)) return outcome;
        step = particular;
    }
    m_untilExact = 0;
    const SolveOutcome outcome = factorize(FactorKind::Double, shape, proximal, stop);
    return outcome.done() ? solve(proximal, step) : outcome;
}

/// Takes the step with a factor of the very shape.
template <int Dim>
SolveOutcome RestMinimizer<Dim>::solve(const ProximalTerm<Dim>* proximal, Points<Dim>& step) {
    Points<Dim> right, y;
    product(step, proximal, right);
    right = -(right + m_reduced);
    y.resize(Dim, right.cols());
    ++m_statistics.iterations;
    const Stopwatch watch(m_statistics.solve);
    if (!m_factor.solve(flat<Dim>(right), flat<Dim>(y), m_workers))
        return {SolveOutcome::Kind::NotFinite, -1};
    m_system.release(y);
    m_system.expand(y, step);
    return step.allFinite() ? SolveOutcome{} : SolveOutcome{SolveOutcome::Kind::NotFinite, -1};
}

/// Moves the shape along a step as far as W falls, and returns which part of it that was; 0 for none. The
/// first trial is the whole step, or kBeforeFlat of the path to the first flat cell, beyond which W is
/// infinite. `descent` is the slope of W along the step, which is negative.
template <int Dim>
double RestMinimizer<Dim>::lineSearch(Points<Dim>& shape, const Points<Dim>& step, double descent,
                                      const ProximalTerm<Dim>* proximal, const Descent<Dim>& how) const {
    const double before = value(shape, proximal), unfolded = m_energy.unfoldedPart(shape, step),
                 rounding = kRounding * std::abs(before);
    double part = unfolded < 1 ? kBeforeFlat * unfolded : 1;
    for (int k = 0; k < kMostHalvings; ++k, part /= 2) {
        Points<Dim> next = shape + part * step;
        if (how.keep) how.keep(next);
        if (!(value(next, proximal) <= before + kArmijo * part * descent + rounding)) continue;
        shape = std::move(next);
        return part;
    }
    return 0;
}

/// Leaves a saddle along what the positive Hessian resists least in a fixed arbitrary load. The load excites
/// every mode a little, and the inverse of the Hessian favours the soft ones. It is the same in every run, so
/// that a shape buckles to the same side.
template <int Dim>
bool RestMinimizer<Dim>::nudge(Points<Dim>& shape) {
    Points<Dim> load(Dim, m_reduced.cols()), y(Dim, m_reduced.cols());
    for (Eigen::Index i = 0; i < load.size(); ++i)
        load(i) = std::sin(1.0 + 7.3 * static_cast<double>(i % 101));
    m_system.release(load);
    if (!m_factor.solve(flat<Dim>(load), flat<Dim>(y), m_workers)) return false;
    m_system.release(y);
    Points<Dim> step = Points<Dim>::Zero(Dim, shape.cols());
    m_system.expand(y, step);
    const double most = step.colwise().norm().maxCoeff();
    if (!(most > 0) || !std::isfinite(most)) return false;
    step *= kNudge / most;
    shape += std::min(1.0, kBeforeFlat * m_energy.unfoldedPart(shape, step)) * step;
    return true;
}

/// Takes Newton steps until they are shorter than the tolerance or W no longer decreases beyond rounding.
/// Near the minimum a factor serves for several steps, of which only the first one counts as an iteration. A
/// step is one of three kinds. Near a saddle, where the exact Hessian is indefinite and a step is short and
/// gains next to nothing, the shape is pushed off. A step below the tolerance is taken as it is, because the
/// line search would compare rounding errors of W. Every other one is searched along; if it gains nothing,
/// first an old factor is replaced, and then the exact Hessian by one with less negative curvature, before
/// the descent ends.
template <int Dim>
Descended RestMinimizer<Dim>::minimize(Points<Dim>& shape, const Descent<Dim>& descent,
                                       const ProximalTerm<Dim>* proximal, const std::stop_token& stop) {
    Descended result;
    if (m_system.unknowns().empty()) {  // every vertex is held: there is one shape
        result.isConverged = true;
        return result;
    }
    int nudges = 0;
    const bool isLive = descent.reusesFactor;
    bool small = false, serves = isLive && m_isMade, isOwn = false;  // isOwn: the factor of this very shape
    if (!isLive) m_untilExact = 0;
    double last = std::numeric_limits<double>::infinity();  // displacement
    for (;; result.iterations += isOwn || isLive) {
        result.isConverged = small && (isLive || m_isExact);
        if (result.isConverged) return result;
        result.isConverged = slope(shape, proximal) <= kNoForce;
        if (result.isConverged || result.iterations >= descent.mostIterations) return result;
        if (stop.stop_requested()) result.outcome = {SolveOutcome::Kind::Stopped, -1};
        if (result.outcome.done() && !serves)
            result.outcome =
                factorize(isLive ? FactorKind::Single : FactorKind::Double, shape, proximal, stop);
        if (!result.outcome.done()) return result;
        isOwn = !serves;
        Points<Dim> right = -m_reduced, y(Dim, right.cols()), step = Points<Dim>::Zero(Dim, shape.cols());
        ++m_statistics.iterations;
        if (!m_factor.solve(flat<Dim>(right), flat<Dim>(y), m_workers)) {
            result.outcome = {SolveOutcome::Kind::NotFinite, -1};
            return result;
        }
        m_system.release(y);
        m_system.expand(y, step);
        const double most = step.colwise().norm().maxCoeff();
        const double decrement = -m_reduced.cwiseProduct(y).sum();
        const double contraction = most / std::exchange(last, most);
        const bool leavesLittle = isOwn || isLive || most * contraction <= kLeft * descent.tolerance;
        if (!m_isExact && most <= kNudge && nudges < kMostNudges &&
            decrement <= kNearSaddle * std::abs(value(shape, proximal))) {
            result.isStable = false;
            ++nudges;
            if (!nudge(shape)) return result;
            if (descent.keep) descent.keep(shape);
            continue;
        }
        if (!m_isExact && most <= descent.tolerance) return result;  // a saddle that cannot be left
        if ((isLive || (m_isExact && leavesLittle)) && most <= descent.tolerance &&
            m_energy.unfoldedPart(shape, step) >= 1) {  // W changes by little more than rounding
            shape += step;
            if (descent.keep) descent.keep(shape);
            small = true;
            continue;
        }
        const double part = lineSearch(shape, step, -decrement, proximal, descent);
        small = part * most <= descent.tolerance && leavesLittle;
        if (part == 0 && std::exchange(serves, false)) continue;
        serves =
            part == 1 && (isLive ? contraction < kQuickly
                                 : m_isExact && most <= kNearby && (isOwn || contraction <= kVeryQuickly));
        if (part == 0) {
            if (m_isExact && most > descent.tolerance) {  // far from the minimum
                m_untilExact = 1;
                m_isExact = false;
                continue;
            }
            result.isConverged = most <= descent.tolerance;
            return result;
        }
    }
}

template class RestMinimizer<2>;
template class RestMinimizer<3>;

}  // namespace wend
