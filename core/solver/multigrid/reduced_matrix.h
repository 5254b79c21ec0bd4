#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/assembly/back_end.h"
#include "core/solver/multigrid/block_rows.h"
#include "core/solver/reduced_system.h"

namespace wend {

/// Holds K = Zᵀ A Z, or its first rows, as blocks in single precision, with all columns of each row. Products
/// within a preconditioner are several times as fast with it as without a matrix. Rows are made one by one
/// from the contributions around their vertices, with the same bits for any number of threads.
template <int Dim>
class ReducedMatrix {
  public:
    /// Prepares the pattern of the rows of the first `rows` unknowns; the columns are all unknowns. The
    /// arguments must outlive this object.
    void analyze(const AssemblyPlan<Dim>& plan, const ReducedSystem<Dim>& system, int rows,
                 WorkerPool& workers);
    /// Computes the values at the back end's shape. Coordinates in which a vertex is held have nothing but
    /// the diagonal. Returns false if the threads are stopped.
    bool build(BackEnd<Dim>& backEnd);

    const BlockRows<Dim>& blocks() const { return m_blocks; }

  private:
    class Rows;

    const AssemblyPlan<Dim>* m_plan = nullptr;
    const ReducedSystem<Dim>* m_system = nullptr;
    // Vertices other than its own that depend on an unknown, and their coefficients; empty: none do.
    std::vector<int> m_followerStart;
    std::vector<std::pair<int, double>> m_followers;
    BlockRows<Dim> m_blocks;
};

}  // namespace wend
