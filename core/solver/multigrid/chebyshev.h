#pragma once

#include <vector>

#include "core/factor/worker_pool.h"
#include "core/solver/multigrid/block_rows.h"
#include "core/solver/part_links.h"

namespace wend {

/// Chebyshev's iteration for K z = r with the inverse diagonal blocks D⁻¹ of K, a smoother: it damps all
/// that has eigenvalues of D⁻¹K in the upper part of the spectrum. A fixed polynomial in D⁻¹K, so that it is
/// symmetric.
template <int Size>
class Chebyshev {
  public:
    using Inverse = Eigen::Matrix<float, Size, Size>;

    /// `held`: coordinates that are 0 in all vectors (bits, one per block, or empty). Estimates the largest
    /// eigenvalue by so many steps of Lanczos' method. False if the blocks are not positive definite.
    bool prepare(const BlockRows<Size>& K, const std::vector<unsigned>& held, const PartLinks& links,
                 WorkerPool& workers);

    /// z += q(D⁻¹K) D⁻¹ r, r ← r − K (what was added to z) if `residual`, else r is spoilt.
    void smooth(int degree, bool residual, const BlockRows<Size>& K, Points<Size>& r, Points<Size>& z,
                const PartLinks& links, WorkerPool& workers);

    /// Upper bound of the eigenvalues of D⁻¹K.
    double largest() const { return m_largest; }
    const Inverse& inverse(int row) const { return m_inverse[row]; }

  private:
    bool invertDiagonal(const BlockRows<Size>& K, const std::vector<unsigned>& held);

    std::vector<Inverse> m_inverse;
    double m_largest = 0;
    Points<Size> m_d, m_next;  // a column per column of K
};

/// Kx in all rows, over the threads.
template <int Size>
void multiply(const BlockRows<Size>& K, const Points<Size>& x, Points<Size>& Kx, WorkerPool& workers);
/// r ← r − K x.
template <int Size>
void subtractProduct(const BlockRows<Size>& K, const Points<Size>& x, Points<Size>& r, WorkerPool& workers);

}  // namespace wend
