#pragma once

#include <vector>

#include "core/factor/worker_pool.h"
#include "core/solver/multigrid/block_rows.h"
#include "core/solver/part_links.h"

namespace wend {

/// Smooths by Chebyshev's iteration for K z = r with the inverse diagonal blocks D⁻¹ of K: it damps
/// everything that has eigenvalues of D⁻¹K in the upper part of the spectrum. It is a fixed polynomial in
/// D⁻¹K and hence symmetric.
template <int Size>
class Chebyshev {
  public:
    using Inverse = Eigen::Matrix<float, Size, Size>;

    /// Inverts the diagonal blocks, and estimates the largest eigenvalue by some steps of Lanczos' method.
    /// `held` are the coordinates that are 0 in all vectors (bits, one per block, or empty). Returns false if
    /// the blocks are not positive definite.
    bool prepare(const BlockRows<Size>& K, const std::vector<unsigned>& held, const PartLinks& links,
                 WorkerPool& workers);

    /// Computes z += q(D⁻¹K) D⁻¹ r. If `residual`, r becomes r − K (what was added to z), otherwise it is
    /// overwritten.
    void smooth(int degree, bool residual, const BlockRows<Size>& K, Points<Size>& r, Points<Size>& z,
                const PartLinks& links, WorkerPool& workers);

    /// Returns an upper bound of the eigenvalues of D⁻¹K.
    double largest() const { return m_largest; }
    const Inverse& inverse(int row) const { return m_inverse[row]; }

  private:
    bool invertDiagonal(const BlockRows<Size>& K, const std::vector<unsigned>& held);

    std::vector<Inverse> m_inverse;
    double m_largest = 0;
    Points<Size> m_d, m_next;  // a column per column of K
};

/// Computes Kx = K x in all rows, with all threads.
template <int Size>
void multiply(const BlockRows<Size>& K, const Points<Size>& x, Points<Size>& Kx, WorkerPool& workers);
/// Computes r ← r − K x.
template <int Size>
void subtractProduct(const BlockRows<Size>& K, const Points<Size>& x, Points<Size>& r, WorkerPool& workers);

}  // namespace wend
