#include "core/factor/factor.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/memory.h"
#include "core/base/simd_target.h"

namespace wend {
namespace {

/// Our own factorization is the quicker one up to these numbers of operations per entry of the factor. The
/// more operations, the larger the fronts, and the less CHOLMOD's cost of a small front counts beside its
/// BLAS.
struct Limits {
    double single, twice;
};
constexpr double kAlways = std::numeric_limits<double>::infinity();
// The limits are indexed by SimdTarget. They were measured on an EPYC with AVX2 (November 2026, one thread,
// processor time). That is hard on the lesser targets, because CHOLMOD's OpenBLAS used AVX2 there. CHOLMOD's
// time divided by ours, single and double, at 173, 227, 502 and 1119 operations an entry (2d-40k, 3d-1.5k,
// 3d-5k, 3d-20k): sse2 1.7 1.2 0.9 0.6, 1.4 0.7 0.6 0.4; ssse3 1.5 1.3 1.2 0.7, 1.9 0.6 0.6 0.5; sse4 2.0 1.1
// 1.0 0.7, 1.8 0.9 0.7 0.5; avx2 5.3 2.0 2.7 1.8, 3.1 1.3 1.4 0.9. With AVX-512 it was 2.8 to 5.8 before. At
// 180 operations (2d-11k) sse2 has 1.5 and 0.97.
constexpr std::array<Limits, 5> kLimits = {
    {{300, 175}, {400, 180}, {400, 180}, {kAlways, 1000}, {kAlways, kAlways}}};

constexpr double kLong = 2e10;  // floating-point operations: half a second and more

}  // namespace

bool Factor::analyze(const std::vector<int>& columnStart, const std::vector<int>& row, int blockSize,
                     Ordering ordering, const std::stop_token& stop) {
    m_own = OfCholmod();
    return m_cholesky.analyze(columnStart, row, blockSize, ordering, stop);
}

void Factor::requireRoom(double bytes, double toTake) {
    m_needed = std::max(m_needed, bytes);
    if (toTake > 0) requireMemory(toTake);
}

/// Factorizes by Wend's own factor of this precision. If there is one already, what follows from the pattern
/// is kept.
template <class Real>
bool Factor::factorizeOwn(WorkerPool& workers, const std::stop_token& stop, const FactorProgress& progress) {
    using Own = SupernodalFactor<Real>;
    if (!std::holds_alternative<Own>(m_own)) {
        m_own = OfCholmod();  // never two at a time
        m_own.template emplace<Own>(m_cholesky.supernodes(), m_cholesky.columnStart(), m_cholesky.row());
    }
    Own& own = std::get<Own>(m_own);
    requireRoom(own.bytes(workers.threads()), own.bytesToTake(workers.threads()));
    const bool isLong = flops() > kLong;
    return own.factorize(m_cholesky.values(), workers, stop, isLong ? progress : FactorProgress());
}

FactorKind Factor::quickest(FactorKind kind) const {
    if (kind == FactorKind::Reference || entries() == 0) return kind;
    const Limits& limits = kLimits[static_cast<std::size_t>(simdTarget())];
    const double limit = kind == FactorKind::Single ? limits.single : limits.twice;
    return flops() <= limit * entries() ? kind : FactorKind::Reference;
}

Factor::Status Factor::factorize(FactorKind kind, WorkerPool& workers, std::stop_token stop,
                                 const FactorProgress& progress) {
    const auto stopped = [&] { return stop.stop_requested() ? Status::Stopped : Status::Done; };
    if (kind == FactorKind::Single && (factorizeOwn<float>(workers, stop, progress) || stop.stop_requested()))
        return stopped();
    if (kind != FactorKind::Reference &&
        (factorizeOwn<double>(workers, stop, progress) || stop.stop_requested()))
        return stopped();
    m_own = OfCholmod();
    requireRoom(m_cholesky.bytes(), m_cholesky.hasNumbers() ? 0 : m_cholesky.bytes());
    switch (m_cholesky.factorize(stop)) {
        case Cholesky::Status::Stopped:
            return Status::Stopped;
        case Cholesky::Status::NotFinite:
            return Status::NotFinite;
        case Cholesky::Status::NotPositiveDefinite:
            return Status::NotPositiveDefinite;
        case Cholesky::Status::Done:
            break;
    }
    return stopped();
}

bool Factor::solve(std::span<const double> b, std::span<double> x, WorkerPool& workers) {
    if (auto* single = std::get_if<SupernodalFactor<float>>(&m_own)) return single->solve(b, x, workers);
    if (auto* own = std::get_if<SupernodalFactor<double>>(&m_own)) return own->solve(b, x, workers);
    return m_cholesky.solve(b, x) == Cholesky::Status::Done;
}

}  // namespace wend
