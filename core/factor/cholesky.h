#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/factor/supernodes.h"

namespace wend {

enum class Ordering { MinimumDegree, NestedDissection };

/// Sparse Cholesky factorization by CHOLMOD, supernodal: the symbolic analysis once per pattern, then
/// numbers. One thread uses it at a time; the analysis is serialized over all instances, because METIS orders
/// by a global random sequence.
class Cholesky {
  public:
    enum class Status { Done, NotPositiveDefinite, NotFinite, Stopped };

    Cholesky();
    ~Cholesky();
    Cholesky(const Cholesky&) = delete;
    Cholesky& operator=(const Cholesky&) = delete;

    /// Pattern of the lower triangle by columns, rows ascending (entries above the diagonal are ignored).
    /// `blockSize` consecutive unknowns have one pattern: they are ordered as one. Throws std::bad_alloc if
    /// there is not enough memory. False if it was stopped. CHOLMOD cannot be: what is stopped is left to
    /// itself, in a thread that owns it, and nothing is analyzed then.
    bool analyze(const std::vector<int>& columnStart, const std::vector<int>& row, int blockSize,
                 Ordering ordering, const std::stop_token& stop = {});
    bool isAnalyzed() const;
    /// The pattern that was analyzed.
    std::span<const int> columnStart() const;
    std::span<const int> row() const;
    /// Where the caller writes its values.
    std::span<double> values();
    /// Computes the supernodal factor L of P K Pᵀ = L Lᵀ (CHOLMOD) from values() with the permutation P of
    /// analyze(), which must come first. Returns NotPositiveDefinite if a pivot is not positive and NotFinite
    /// if a value is not finite; then there is no factor to solve with. Throws std::bad_alloc.
    /// Returns Stopped if `stop` was requested; then it has to be analyzed again.
    Status factorize(const std::stop_token& stop = {});
    /// Counted by the analysis: floating-point operations of a factorization and entries of the factor.
    double factorFlops() const;
    double factorEntries() const;
    /// Bytes of the numeric factor, and whether they have been taken.
    double bytes() const;
    bool hasNumbers() const;
    /// The factor's structure.
    Supernodes supernodes() const;
    /// x = K⁻¹ b; b and x may be the same.
    Status solve(std::span<const double> b, std::span<double> x);

  private:
    struct Handles;
    bool run(void (*work)(Handles&), const std::stop_token& stop);

    std::shared_ptr<Handles> m_handles;  // shared with a thread that works on them
};

}  // namespace wend
