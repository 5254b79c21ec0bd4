#pragma once

#include <stop_token>

#include "core/solver/multigrid/algebraic_hierarchy.h"
#include "core/solver/multigrid/coarse_space.h"

namespace wend {

/// The coarse matrix Pᵀ K P, made from the local forms without K itself, and the diagonal blocks of K. Sums
/// run in the order of cells and facets: the same bits for any number of threads.
template <int Dim>
class Galerkin {
  public:
    static constexpr int kModes = CoarseSpace<Dim>::kModes;

    /// The pattern, once per coarse space.
    void analyze(const CoarseSpace<Dim>& space);
    /// Motions that are missing get a 1 on the diagonal. Returns false once `stop` is requested.
    bool build(const CoarseSpace<Dim>& space, const LocalForms<Dim>& forms, WorkerPool& workers,
               const std::stop_token& stop);

    const BlockMatrix& matrix() const { return m_matrix; }
    /// One per vertex; of a dependent vertex spread to those that it follows.
    const std::vector<Mat<Dim>>& diagonal() const { return m_diagonal; }

  private:
    struct Part;
    void compute(const CoarseSpace<Dim>& space, const typename LocalForms<Dim>::Form& form, Part& part) const;
    void add(const Part& part, int rowClass);
    int placeOf(int row, int column) const;
    void mirror(WorkerPool& workers);
    Eigen::Map<typename CoarseSpace<Dim>::Square> block(int place) {
        return Eigen::Map<typename CoarseSpace<Dim>::Square>(
            m_matrix.values.data() + static_cast<std::size_t>(place) * m_matrix.blockEntries());
    }

    BlockMatrix m_matrix;
    std::vector<Mat<Dim>> m_diagonal;
};

}  // namespace wend
