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

/// Conjugate gradients for K y = −Zᵀ (A v + f), K = Zᵀ A Z applied without the matrix, with a Cholesky factor
/// of an earlier K as preconditioner: the factor of a nearby shape is spectrally close, so a few iterations
/// do. Keeps its vectors between runs.
template <int Dim>
class ConjugateGradients {
  public:
    /// z ≈ K⁻¹ r, symmetric and positive definite; false if that is not finite.
    using Preconditioner = std::function<bool(std::span<const double> r, std::span<double> z)>;
    struct Goal {
        double tolerance = 0;    // error allowed, relative to the largest nodal velocity
        double contraction = 1;  // by how much the first step is expected to reduce the error
        // And by how much any step at best: z shows little of what the factor can hardly see, which is what a
        // matrix of bad condition loses in single precision.
        double minContraction = 0.05;
        // A step that leaves more ends the run: such a factor is not to be trusted.
        double poorestContraction = std::numeric_limits<double>::infinity();
        /// Whether to give up, if about so many iterations are still to do: as the last one tells, or, since
        /// |z| need not fall in every one, as the mean of all tells after more than so many.
        std::function<bool(double iterations)> hopeless;
        // Whether |z| shows only a part of the error: of multigrid, whose B K has eigenvalues well below 1.
        bool cautious = false;
        int trials = 1;
        int most = 200;                             // iterations, far beyond what ever pays with a factor
        std::stop_token stop = {};                  // gives up between iterations
        std::function<void(double)> progress = {};  // gets the part that is done, in [0, 1], as it seems
    };
    struct Result {
        enum class End { Converged, GaveUp } end = End::GaveUp;
        int iterations = 0;
        // As measured, which may be 1 or more: |z| need not fall in every step. None of one iteration alone.
        std::optional<double> firstContraction, worstContraction;
    };

    /// v += Z y, from a v that meets the constraints. The error after a step is estimated as what all further
    /// ones would add, |z| (ρ + ρ² + …) = |z| ρ / (1 − ρ): z the preconditioned residual before the step, ρ
    /// the last contraction of |z|, both in the maximum norm, but no less than goal.minContraction. A
    /// cautious goal takes the mean contraction where that is worse, and (1 + ρ) / (1 − ρ) times the
    /// estimate: the root of the condition number that conjugate gradients have at that rate. The step that
    /// would bring it under the tolerance is the last. Where it need not bring much it is z itself, without
    /// the product that tells how far to go along it: within a few percent as far as that. `load` is f, one
    /// column per vertex; null: none.
    /// In a part of a divided system v is that of all of its vertices, on entry and at the end, and what the
    /// preconditioner gives counts for the part's own unknowns only. The stop and `hopeless` count in the
    /// first part.
    Result run(BackEnd<Dim>& backEnd, const ReducedSystem<Dim>& system, const Preconditioner& precondition,
               const Goal& goal, const Points<Dim>* load, Points<Dim>& v, const PartLinks& links = {});

  private:
    Points<Dim> m_r, m_z, m_p, m_q;   // per unknown vertex
    Points<Dim> m_lifted, m_Alifted;  // per vertex
};

}  // namespace wend
