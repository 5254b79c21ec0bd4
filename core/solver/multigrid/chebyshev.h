#pragma once

#include <functional>
#include <vector>

#include "core/factor/worker_pool.h"
#include "core/mesh/types.h"

namespace wend {

/// Chebyshev's iteration for K z = r with the inverse diagonal blocks D⁻¹ of K, a smoother: it damps all
/// that has eigenvalues of D⁻¹K in the upper part of the spectrum. A fixed polynomial in D⁻¹K, so that it is
/// symmetric.
template <int Dim>
class Chebyshev {
  public:
    /// Kx.
    using Product = std::function<void(const Points<Dim>& x, Points<Dim>& Kx)>;

    /// `held`: coordinates that are 0 in all vectors (bits, one per block, or empty). Estimates the largest
    /// eigenvalue by so many steps of Lanczos' method. False if the blocks are not positive definite.
    bool prepare(std::vector<Mat<Dim>> diagonal, const std::vector<unsigned>& held, const Product& product,
                 WorkerPool& workers);

    /// z += q(D⁻¹K) D⁻¹ r, r ← r − K (what was added to z) if `residual`, else r is spoilt.
    void smooth(int degree, bool residual, const Product& product, Points<Dim>& r, Points<Dim>& z,
                WorkerPool& workers);

    double largest() const { return m_largest; }

  private:
    void applyInverse(const Points<Dim>& r, Points<Dim>& z, WorkerPool& workers) const;

    std::vector<Mat<Dim>> m_inverse;
    double m_largest = 0;
    Points<Dim> m_d, m_Kd, m_s;
};

}  // namespace wend
