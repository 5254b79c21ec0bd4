#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/factor/supernodes.h"

namespace wend {

/// Selects the fill-reducing ordering.
enum class Ordering { MinimumDegree, NestedDissection };
/// Returns the quicker ordering for a mesh with so many free vertices: in the plane minimum degree makes no
/// more fill below 8000.
constexpr Ordering orderingFor(int dimension, std::size_t vertices) {
    return dimension == 2 && vertices < 8000 ? Ordering::MinimumDegree : Ordering::NestedDissection;
}

/// Factorizes sparse symmetric positive definite matrices by CHOLMOD, with supernodes: the symbolic analysis
/// is done once per pattern, the numeric factorization for every set of values. One thread uses it at a time;
/// analyses are serialized over all instances, because METIS orders by a global random sequence.
class Cholesky {
  public:
    /// How an operation ended. NotPositiveDefinite is a pivot ≤ 0, NotFinite a value that is NaN or infinite.
    enum class Status { Done, NotPositiveDefinite, NotFinite, Stopped };

    Cholesky();
    ~Cholesky();
    Cholesky(const Cholesky&) = delete;
    Cholesky& operator=(const Cholesky&) = delete;

    /// Analyzes a pattern: the lower triangle by columns, rows ascending (entries above the diagonal are
    /// ignored). Every `blockSize` consecutive unknowns share one pattern and are ordered as one. Returns
    /// false if it was stopped. CHOLMOD cannot be interrupted: a stopped analysis is left to a thread that
    /// owns it, and nothing is analyzed then. Throws std::bad_alloc if there is not enough memory.
    bool analyze(const std::vector<int>& columnStart, const std::vector<int>& row, int blockSize,
                 Ordering ordering, const std::stop_token& stop = {});
    bool isAnalyzed() const;
    /// Return the analyzed pattern.
    std::span<const int> columnStart() const;
    std::span<const int> row() const;
    /// Returns the array into which the caller writes the values.
    std::span<double> values();
    /// Computes the supernodal factor L of P K Pᵀ = L Lᵀ (CHOLMOD; Chen, Davis, Hager, Rajamanickam 2008)
    /// from values() with the permutation P of analyze(), which must come first. It takes factorFlops()
    /// operations on one thread, and has the same bits in every run. Returns NotPositiveDefinite if a pivot
    /// is not positive and NotFinite if a value is not finite; then there is no factor to solve with, but the
    /// analysis stays. Returns Stopped if `stop` was requested; then the pattern has to be analyzed again.
    /// Systems of fewer than 15,000 unknowns are not stopped. Throws std::bad_alloc.
    Status factorize(const std::stop_token& stop = {});
    /// Return the counts of the analysis: floating-point operations of a factorization and entries of the
    /// factor.
    double factorFlops() const;
    double factorEntries() const;
    /// Return the bytes of the numeric factor, and whether they have been allocated.
    double bytes() const;
    bool hasNumbers() const;
    /// Returns the structure of the factor.
    Supernodes supernodes() const;
    /// Solves x = K⁻¹ b; b and x may be the same array. Both have one number per unknown. Returns NotFinite,
    /// with x as it was, if the result is not finite. Throws std::bad_alloc.
    Status solve(std::span<const double> b, std::span<double> x);

  private:
    struct Handles;
    bool run(void (*work)(Handles&), const std::stop_token& stop);

    std::shared_ptr<Handles> m_handles;  // shared with a thread that works on them
};

}  // namespace wend
