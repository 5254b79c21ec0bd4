#include "core/factor/factor.h"

namespace wend {

void Factor::analyze(const std::vector<int>& columnStart, const std::vector<int>& row, int blockSize,
                     Ordering ordering) {
    m_own = OfCholmod();
    m_cholesky.analyze(columnStart, row, blockSize, ordering);
}

/// One of this kind that is there already keeps what follows from the pattern.
template <class Real>
bool Factor::factorizeOwn(WorkerPool& workers, const std::stop_token& stop) {
    using Own = SupernodalFactor<Real>;
    if (!std::holds_alternative<Own>(m_own)) {
        m_own = OfCholmod();  // never two at a time
        m_own.template emplace<Own>(m_cholesky.supernodes(), m_cholesky.columnStart(), m_cholesky.row());
    }
    return std::get<Own>(m_own).factorize(m_cholesky.values(), workers, stop);
}

Factor::Status Factor::factorize(FactorKind kind, WorkerPool& workers, std::stop_token stop) {
    const auto stopped = [&] { return stop.stop_requested() ? Status::Stopped : Status::Done; };
    if (kind == FactorKind::Single && (factorizeOwn<float>(workers, stop) || stop.stop_requested()))
        return stopped();
    if (kind != FactorKind::Reference && (factorizeOwn<double>(workers, stop) || stop.stop_requested()))
        return stopped();
    m_own = OfCholmod();
    switch (m_cholesky.factorize()) {
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
