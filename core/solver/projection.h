#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/solver/constraint_rows.h"
#include "core/solver/dense_systems.h"

namespace wend {

/// Computes the least-norm correction of nodal values that makes independent rows hold: x += Wᵀ (W Wᵀ)⁻¹
/// (target − W x). Rows of one vertex set it; the others are factorized in clusters of rows that share
/// movable vertices.
template <int Dim>
class Projection {
  public:
    Projection() = default;
    Projection(const std::vector<ConstraintRow>& rows, const std::vector<DependentRow>& dependent,
               int vertexCount);
    /// Corrects the values (Dim × n); `targets` has one column per row. Clusters are corrected twice, since
    /// the second pass takes the rounding of the first away. Columns of dependent rows do not count.
    void apply(Points<Dim>& values, const Points<Dim>& targets) const;

  private:
    /// A vertex that a row of one term sets.
    struct Fixed {
        int vertex, row;
        double weight;
    };
    /// Rows that share movable vertices, and are therefore corrected together.
    struct Cluster {
        std::vector<int> rows, vertices;  // vertices: the movable ones
        RightInverse inverse;             // of the matrix W of these rows and vertices
    };
    void addCluster(std::vector<int> rows, const std::vector<bool>& isFixed);
    void correct(const Cluster& cluster, Points<Dim>& values, const Points<Dim>& targets) const;

    std::vector<ConstraintRow> m_rows;
    std::vector<Fixed> m_fixed;
    std::vector<Cluster> m_clusters;
};

}  // namespace wend
