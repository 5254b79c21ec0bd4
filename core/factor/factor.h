#pragma once

#include <span>
#include <stop_token>
#include <variant>
#include <vector>

#include "core/factor/cholesky.h"
#include "core/factor/factor_kind.h"
#include "core/factor/supernodal_factor.h"
#include "core/factor/worker_pool.h"

namespace wend {

/// Holds the Cholesky factor of a symmetric positive definite matrix, in one kind at a time, because a factor
/// takes most of the memory. One thread uses it at a time.
class Factor {
  public:
    /// How an operation ended; see Cholesky::Status.
    enum class Status { Done, NotPositiveDefinite, NotFinite, Stopped };

    /// Analyzes a pattern as Cholesky::analyze() does, and drops an earlier factor.
    bool analyze(const std::vector<int>& columnStart, const std::vector<int>& row, int blockSize,
                 Ordering ordering, const std::stop_token& stop = {});
    bool isAnalyzed() const { return m_cholesky.isAnalyzed(); }
    /// Returns the array into which the caller writes the values of the pattern.
    std::span<double> values() { return m_cholesky.values(); }
    /// Factorizes the values in this kind, or in the first kind after it that loses no pivot. If CHOLMOD's
    /// factorization is stopped, the pattern is no longer analyzed. `progress` gets the fraction done, from
    /// any thread, in long factorizations other than CHOLMOD's. Throws NotEnoughMemory before it allocates a
    /// factor that does not fit. The pattern must be analyzed. NotPositiveDefinite means that CHOLMOD found a
    /// pivot ≤ 0 as well.
    Status factorize(FactorKind kind, WorkerPool& workers, std::stop_token stop = {},
                     const FactorProgress& progress = {});
    /// Returns the kind, or Reference if CHOLMOD factorizes the pattern faster on the SIMD target in use. It
    /// is decided by counted work and therefore the same on every machine.
    FactorKind quickest(FactorKind kind) const;
    /// Returns the kind of the last factorization.
    FactorKind kind() const { return static_cast<FactorKind>(m_own.index()); }
    /// Solves x ≈ K⁻¹ b; returns false if the result is not finite. Both spans have one number per unknown,
    /// in the order of the pattern. In single precision the result is a preconditioner's, off by about the
    /// condition number times 1e-7.
    bool solve(std::span<const double> b, std::span<double> x, WorkerPool& workers);

    /// Return the counts of the analysis: floating-point operations of a factorization and entries of the
    /// factor.
    double flops() const { return m_cholesky.factorFlops(); }
    double entries() const { return m_cholesky.factorEntries(); }
    /// Returns the bytes of the largest factor so far, including one that did not fit.
    double needed() const { return m_needed; }

  private:
    struct OfCholmod {};
    template <class Real>
    bool factorizeOwn(WorkerPool& workers, const std::stop_token& stop, const FactorProgress& progress);
    void requireRoom(double bytes, double toTake);

    Cholesky m_cholesky;
    std::variant<SupernodalFactor<float>, SupernodalFactor<double>, OfCholmod> m_own = OfCholmod();
    double m_needed = 0;
};

}  // namespace wend
