#include "app/mpi/divided_coarse.h"

namespace wend {
namespace {

/// Calls `visit` with every list of a share, in the order in which they are sent.
template <class Share, class Visit>
void forLists(Share& share, Visit&& visit) {
    visit(share.rows);
    visit(share.count);
    visit(share.columns);
    visit(share.missing);
    visit(share.blocks);
    visit(share.rests);
    visit(share.own);
    visit(share.motions);
}

template <int Modes>
Packet packed(const CoarseShare<Modes>& share) {
    Packet packet;
    forLists(share, [&](const auto& list) { packet.put(list); });
    return packet;
}

template <int Modes>
CoarseShare<Modes> unpacked(Packet packet) {
    CoarseShare<Modes> share;
    forLists(share, [&](auto& list) { packet.get(list); });
    return share;
}

template <int Modes>
std::span<double> flat(Points<Modes>& points) {
    return {points.data(), static_cast<std::size_t>(points.size())};
}

}  // namespace

template <int Modes>
DividedCoarse<Modes>::DividedCoarse(const Team& team, Graph aggregates, WorkerPool& workers)
    : m_team(team), m_levels(workers) {
    if (team.isFirst()) m_levels.analyze(std::move(aggregates));
}

/// Runs in the first process.
template <int Modes>
BuildStatus DividedCoarse<Modes>::gather(CoarseShare<Modes> share) {
    std::vector<CoarseShare<Modes>> shares;
    shares.push_back(std::move(share));
    for (int rank = 1; rank < m_team.size(); ++rank) shares.push_back(unpacked<Modes>(m_team.receive(rank)));
    m_rows.clear();
    for (const auto& one : shares) m_rows.push_back(one.rows);
    auto whole = merged<Modes>(shares);
    whole.motions.resize(whole.rows.size());
    for (const auto& one : shares)
        for (std::size_t i = 0; i < one.own.size(); ++i) whole.motions[one.own[i]] = one.motions[i];
    shares = {};
    m_size = static_cast<int>(whole.rows.size());
    return m_levels.build(std::move(whole));
}

template <int Modes>
BuildStatus DividedCoarse<Modes>::build(CoarseShare<Modes> share) {
    auto status = BuildStatus::Done;
    if (!m_team.isFirst()) m_team.send(0, packed(share));
    m_team.together([&] {
        if (m_team.isFirst()) status = gather(std::move(share));
    });
    if (!m_team.decide(status != BuildStatus::Stopped)) return BuildStatus::Stopped;
    return m_team.decide(status == BuildStatus::Done) ? BuildStatus::Done : BuildStatus::NotPositiveDefinite;
}

/// Sums the right-hand sides of all shares, in their order, in the first process.
template <int Modes>
bool DividedCoarse<Modes>::solveWhole(const Points<Modes>& r, Points<Modes>& z) {
    m_right.setZero(Modes, m_size);
    for (int rank = 0; rank < m_team.size(); ++rank) {
        const auto& rows = m_rows[rank];
        m_values.resize(Modes, static_cast<Eigen::Index>(rows.size()));
        if (rank > 0) m_team.receive(rank, flat<Modes>(m_values));
        const Points<Modes>& values = rank > 0 ? m_values : r;
        for (std::size_t i = 0; i < rows.size(); ++i)
            m_right.col(rows[i]) += values.col(static_cast<Eigen::Index>(i));
    }
    const bool finite = m_levels.solve(m_right, m_result);
    for (int rank = m_team.size() - 1; rank >= 0; --rank) {
        const auto& rows = m_rows[rank];
        Points<Modes>& values = rank > 0 ? m_values : z;
        values.resize(Modes, static_cast<Eigen::Index>(rows.size()));
        for (std::size_t i = 0; i < rows.size(); ++i)
            values.col(static_cast<Eigen::Index>(i)) = m_result.col(rows[i]);
        if (rank > 0) m_team.send(rank, std::span<const double>(flat<Modes>(m_values)));
    }
    return finite;
}

template <int Modes>
bool DividedCoarse<Modes>::solve(Points<Modes>& r, Points<Modes>& z) {
    bool finite = true;
    if (m_team.isFirst()) {
        finite = solveWhole(r, z);
    } else {
        m_team.send(0, std::span<const double>(flat<Modes>(r)));
        z.resizeLike(r);
        m_team.receive(0, flat<Modes>(z));
    }
    return m_team.decide(finite);
}

template class DividedCoarse<6>;
template class DividedCoarse<12>;

}  // namespace wend
