#pragma once

#include <span>
#include <vector>

#include "core/assembly/assembly_plan.h"
#include "core/factor/worker_pool.h"

namespace wend {

/// Computes the rotation of every vertex's surroundings between two shapes. A factor of the first shape,
/// turned into the second, R (L Lᵀ)⁻¹ Rᵀ, is the better preconditioner there if rigid motion costs little
/// energy and everything else much: towards EQUIA. Elsewhere it is not, because the gradient of R turns
/// translations into strain.
template <int Dim>
class VertexRotations {
  public:
    VertexRotations() = default;
    explicit VertexRotations(const AssemblyPlan<Dim>& plan);

    /// Selects rotations that are smooth, as a preconditioner needs them, or rough.
    enum class Finish { Smooth, Rough };
    /// Computes the best rigid fit of the edges at every vertex. It minimizes Σ_j ‖(y_j − y) − R (x_j − x)‖²
    /// over the edges of a vertex; smooth ones minimize the sum over a neighbourhood that ten sweeps (in
    /// space three) have widened. A vertex without a unique best rotation gets the identity or any rotation,
    /// since only the speed of iterations depends on it.
    void compute(const Points<Dim>& from, const Points<Dim>& to, WorkerPool& workers,
                 Finish finish = Finish::Smooth);

    /// Compute b ← Rᵀ b and b ← R b for a vector of some vertices.
    void turnBack(const std::vector<int>& vertices, std::span<double> b) const;
    void turn(const std::vector<int>& vertices, std::span<double> b) const;
    /// Does the same for all vertices.
    void turn(Points<Dim>& field) const;

  private:
    static constexpr int kNumbers = Dim == 2 ? 2 : 9;  // of a rotation: cosine and sine, or the matrix

    Mat<Dim> rotation(int vertex) const;

    std::vector<int> m_start, m_neighbours;  // per vertex: see rotations::Neighbours
    std::vector<double> m_own;
    std::vector<double> m_rotations, m_other;  // per vertex, in groups
};

}  // namespace wend
