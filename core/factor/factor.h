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

/// The Cholesky factor of a symmetric positive definite matrix, of one kind at a time: a factor is most of
/// the memory. One thread uses it at a time.
class Factor {
  public:
    enum class Status { Done, NotPositiveDefinite, NotFinite, Stopped };

    /// As Cholesky::analyze(); a factor that was there is gone.
    bool analyze(const std::vector<int>& columnStart, const std::vector<int>& row, int blockSize,
                 Ordering ordering, const std::stop_token& stop = {});
    bool isAnalyzed() const { return m_cholesky.isAnalyzed(); }
    /// Where the caller writes the values of the pattern.
    std::span<double> values() { return m_cholesky.values(); }
    /// Of the values, in this kind or the first after it that loses no pivot. If CHOLMOD's is stopped, the
    /// pattern is no longer analyzed. `progress` gets the part that is done, where that takes long and is not
    /// CHOLMOD's, from any thread. Throws NotEnoughMemory before it takes any for a factor that does not fit.
    Status factorize(FactorKind kind, WorkerPool& workers, std::stop_token stop = {},
                     const FactorProgress& progress = {});
    /// Returns the kind, or Reference where CHOLMOD factorizes the pattern sooner on the SIMD target in use:
    /// by counted work, the same on every machine.
    FactorKind quickest(FactorKind kind) const;
    /// Of the last factorization.
    FactorKind kind() const { return static_cast<FactorKind>(m_own.index()); }
    /// x ≈ K⁻¹ b; false if that is not finite.
    bool solve(std::span<const double> b, std::span<double> x, WorkerPool& workers);

    /// Counted by the analysis: floating-point operations of a factorization and entries of the factor.
    double flops() const { return m_cholesky.factorFlops(); }
    double entries() const { return m_cholesky.factorEntries(); }
    /// Bytes of the largest factor so far, also of one that did not fit.
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
