#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>

#include "core/assembly/back_end.h"
#include "core/solver/part_links.h"
#include "core/solver/reduced_system.h"

namespace wend {

/// Solves K y = −Zᵀ (A v + f) by conjugate gradients, with K = Zᵀ A Z applied without the matrix, and a
/// Cholesky factor of an earlier K as preconditioner: the factor of a nearby shape is spectrally close, so
/// that a few iterations suffice. Keeps its vectors between runs.
template <int Dim>
class ConjugateGradients {
  public:
    /// Computes z ≈ K⁻¹ r by a symmetric, positive definite operator; returns false if the result is not
    /// finite.
    using Preconditioner = std::function<bool(std::span<const double> r, std::span<double> z)>;
    /// The accuracy that a run needs, and its limits.
    struct Goal {
        double tolerance = 0;    // error allowed, relative to the largest nodal velocity
        double contraction = 1;  // by how much the first step is expected to reduce the error
        // No step is assumed to contract more than this: z shows little of the errors that the factor can
        // hardly see, as a matrix of large condition number has them in single precision.
        double minContraction = 0.05;
        // A step that contracts less ends the run, because such a factor is not to be trusted.
        double poorestContraction = std::numeric_limits<double>::infinity();
        /// Returns whether to give up if about so many iterations are left. This number is estimated from the
        /// last iteration or, since |z| need not decrease in every one, from the mean of all after more than
        /// so many.
        std::function<bool(double iterations)> hopeless;
        // True if |z| shows only a part of the error, as with multigrid, whose B K has eigenvalues well below
        // 1.
        bool cautious = false;
        int trials = 1;
        int most = 200;                             // iterations, far beyond what ever pays with a factor
        std::stop_token stop = {};                  // gives up between iterations
        std::function<void(double)> progress = {};  // gets the part that is done, in [0, 1], as it seems
    };
    /// How a run ended.
    struct Result {
        enum class End { Converged, GaveUp } end = End::GaveUp;
        int iterations = 0;
        // The measured contractions. They may be 1 or more, because |z| need not decrease in every step. A
        // run of one iteration has none.
        std::optional<double> firstContraction, worstContraction;
    };

    /// Computes v += Z y, from a v that satisfies the constraints. The error after a step is estimated as the
    /// sum of all further ones, |z| (ρ + ρ² + …) = |z| ρ / (1 − ρ), with z the preconditioned residual before
    /// the step and ρ the last contraction of |z|, both in the maximum norm, but no less than
    /// goal.minContraction. A cautious goal takes the mean contraction where that is worse, and (1 + ρ) / (1
    /// − ρ) times the estimate: the root of the condition number at which conjugate gradients have that rate.
    /// The step that is expected to bring the estimate under the tolerance is the last. If it need not
    /// improve much, it is z itself, without the product that determines the length of the step, which would
    /// differ by a few percent. `load` is f, one column per vertex; null: none.
    /// In a part of a divided system, v is that of all of its vertices, on entry and at the end, and the
    /// result of the preconditioner counts for the part's own unknowns only. The stop and `hopeless` count in
    /// the first part.
    Result run(BackEnd<Dim>& backEnd, const ReducedSystem<Dim>& system, const Preconditioner& precondition,
               const Goal& goal, const Points<Dim>* load, Points<Dim>& v, const PartLinks& links = {});

  private:
    Points<Dim> m_r, m_z, m_p, m_q;   // per unknown vertex
    Points<Dim> m_lifted, m_Alifted;  // per vertex
};

}  // namespace wend
