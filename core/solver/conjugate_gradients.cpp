#include "core/solver/conjugate_gradients.h"

#include <algorithm>
#include <cmath>

#include "core/solver/flat_points.h"

namespace wend {
namespace {

// A last step without its product is assumed to leave at least this part of the error, whatever is expected
// of it.
constexpr double kPlainContraction = 0.25;

/// Returns aᵀ b over the unknowns of all parts.
template <int Dim>
double dot(const Points<Dim>& a, const Points<Dim>& b, const PartLinks& links) {
    const int own = links.own(static_cast<int>(a.cols()));
    return links.sum(a.leftCols(own).cwiseProduct(b.leftCols(own)).sum());
}

template <class Matrix>
double largest(const Matrix& v, const PartLinks& links) {
    return links.largest(v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0);
}

/// Returns how many iterations at a contraction bring a size under a goal.
double iterationsTo(double goal, double size, double contraction) {
    if (contraction >= 1) return std::numeric_limits<double>::infinity();
    return std::max(0.0, std::log(goal / size) / std::log(contraction));
}

/// Returns the error after a step at a contraction, in terms of |z| before it.
double remaining(double contraction, bool cautious) {
    const double sum = contraction / (1 - contraction);
    return cautious ? sum * (1 + contraction) / (1 - contraction) : sum;
}

template <class Result>
void record(double contraction, Result& result) {
    if (!result.firstContraction) result.firstContraction = contraction;
    result.worstContraction = std::max(result.worstContraction.value_or(contraction), contraction);
}

}  // namespace

template <int Dim>
typename ConjugateGradients<Dim>::Result ConjugateGradients<Dim>::run(
    BackEnd<Dim>& backEnd, const ReducedSystem<Dim>& system, const Preconditioner& precondition,
    const Goal& goal, const Points<Dim>* load, Points<Dim>& v, const PartLinks& links) {
    Result result;
    backEnd.apply(v, m_Alifted);
    if (load) m_Alifted += *load;
    system.restrict(m_Alifted, m_r);
    m_r = -m_r;
    m_z.resizeLike(m_r);
    const int own = links.own(static_cast<int>(m_r.cols()));
    const auto allowed = [&] { return goal.tolerance * largest(v, links); };
    double start = 0, before = 0, rzBefore = 0;
    while (result.iterations < goal.most && !links.decide(goal.stop.stop_requested())) {
        if (!precondition(flat<Dim>(m_r), flat<Dim>(m_z))) break;
        // Preconditioners know no held directions but the axes.
        if (!system.sliders().areAlongAxes()) system.release(m_z);
        ++result.iterations;
        const double size = largest(m_z.leftCols(own), links), rz = dot<Dim>(m_r, m_z, links);
        if (size == 0) {
            result.end = Result::End::Converged;
            break;
        }
        const bool first = result.iterations == 1;
        if (first) start = size;
        if (!first) {
            record(size / before, result);
            if (size / before > goal.poorestContraction) break;
        }
        // |z| need not fall in every iteration, so one good ratio is not believed alone: a cautious run takes
        // the mean of all ratios where that is worse.
        const double mean = first ? 1 : std::pow(size / start, 1.0 / (result.iterations - 1));
        double contraction = first ? goal.contraction : std::max(goal.minContraction, size / before);
        if (goal.cautious && !first) contraction = std::max(contraction, mean);
        // If z itself is a good enough last step, the product with the matrix is saved.
        const double plain = std::max(contraction, kPlainContraction);
        if (plain < 1 && size * remaining(plain, goal.cautious) <= allowed()) {
            links.update(flat<Dim>(m_z), Dim);
            system.expand(m_z, v);
            result.end = Result::End::Converged;
            break;
        }
        if (first)
            m_p = m_z;
        else
            m_p = m_z + rz / rzBefore * m_p;
        links.update(flat<Dim>(m_p), Dim);
        m_lifted.setZero(Dim, v.cols());
        system.expand(m_p, m_lifted);
        backEnd.apply(m_lifted, m_Alifted);
        system.restrict(m_Alifted, m_q);
        const double pKp = dot<Dim>(m_p, m_q, links);
        // Not positive: rounding, or a preconditioner that is no longer definite. What was gained so far
        // stays.
        if (!(pKp > 0 && rz > 0)) break;
        v += rz / pKp * m_lifted;
        const double goalSize = allowed();
        if (contraction < 1 && size * remaining(contraction, goal.cautious) <= goalSize) {
            result.end = Result::End::Converged;
            break;
        }
        const double lasting = goal.trials > 1 ? std::max(goal.minContraction, mean) : contraction,
                     left = iterationsTo(goalSize, size, lasting);
        if (result.iterations > goal.trials && links.decide(goal.hopeless && goal.hopeless(left))) break;
        if (goal.progress) goal.progress(result.iterations / (result.iterations + left));
        m_r -= rz / pKp * m_q;
        before = size;
        rzBefore = rz;
    }
    if (links.decide(goal.stop.stop_requested())) result.end = Result::End::GaveUp;  // v may be anything
    return result;
}

template class ConjugateGradients<2>;
template class ConjugateGradients<3>;

}  // namespace wend
