#pragma once

#include <span>
#include <vector>

#include "core/assembly/assembly_plan.h"
#include "core/factor/worker_pool.h"

namespace wend {

/// The rotation of every vertex's surroundings between two shapes. A factor of the first shape, turned into
/// the second, R (L Lᵀ)⁻¹ Rᵀ, is the better preconditioner there where rigid motion is cheap and all else is
/// dear: towards EQUIA. Elsewhere it is not: the gradient of R turns translations into strain.
template <int Dim>
class VertexRotations {
  public:
    VertexRotations() = default;
    explicit VertexRotations(const AssemblyPlan<Dim>& plan);

    /// Of the best rigid fit of the edges at every vertex; smooth as a preconditioner needs them, or rough.
    enum class Finish { Smooth, Rough };
    void compute(const Points<Dim>& from, const Points<Dim>& to, WorkerPool& workers,
                 Finish finish = Finish::Smooth);

    /// b ← Rᵀ b and b ← R b, a vector of some vertices each.
    void turnBack(const std::vector<int>& vertices, std::span<double> b) const;
    void turn(const std::vector<int>& vertices, std::span<double> b) const;
    /// The same of all vertices.
    void turn(Points<Dim>& field) const;

  private:
    static constexpr int kNumbers = Dim == 2 ? 2 : 9;  // of a rotation: cosine and sine, or the matrix

    Mat<Dim> rotation(int vertex) const;

    std::vector<int> m_start, m_neighbours;  // per vertex: see rotations::Neighbours
    std::vector<double> m_own;
    std::vector<double> m_rotations, m_other;  // per vertex, in groups
};

}  // namespace wend
