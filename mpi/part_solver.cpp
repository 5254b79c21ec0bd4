#include "mpi/part_solver.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/assembly/cpu_back_end.h"

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

template <int Dim>
void putPoints(const Points<Dim>& points, Packet& packet) {
    packet.put(std::vector<double>(points.data(), points.data() + points.size()));
}

template <int Dim>
Points<Dim> pointsFrom(Packet& packet) {
    std::vector<double> values;
    packet.get(values);
    return Eigen::Map<const Points<Dim>>(values.data(), Dim, static_cast<Eigen::Index>(values.size()) / Dim);
}

void putPivots(const std::vector<Elimination::Pivot>& pivots, Packet& packet) {
    packet.put(pivots.size());
    for (const auto& pivot : pivots) {
        packet.put(pivot.vertex);
        packet.put(pivot.free);
    }
}

std::vector<Elimination::Pivot> pivotsFrom(Packet& packet) {
    std::size_t count = 0;
    packet.get(count);
    std::vector<Elimination::Pivot> pivots(count);
    for (auto& pivot : pivots) {
        packet.get(pivot.vertex);
        packet.get(pivot.free);
    }
    return pivots;
}

template <int Dim>
void putPart(const Part<Dim>& part, Packet& packet) {
    packet.put(part.number);
    packet.put(part.own);
    packet.put(part.copies);
    packet.put(part.unknowns);
    packet.put(part.vertices);
    packet.put(part.cells);
    packet.put(part.corners);
    packet.put(part.followers);
    packet.put(part.neighbours.size());
    for (const auto& neighbour : part.neighbours) {
        packet.put(neighbour.part);
        packet.put(neighbour.sent);
        packet.put(neighbour.firstCopy);
        packet.put(neighbour.copies);
    }
    putPivots(part.elimination.pivots, packet);
    packet.put(part.sliders);
}

template <int Dim>
Part<Dim> partFrom(Packet& packet) {
    Part<Dim> part;
    packet.get(part.number);
    packet.get(part.own);
    packet.get(part.copies);
    packet.get(part.unknowns);
    packet.get(part.vertices);
    packet.get(part.cells);
    packet.get(part.corners);
    packet.get(part.followers);
    std::size_t neighbours = 0;
    packet.get(neighbours);
    part.neighbours.resize(neighbours);
    for (auto& neighbour : part.neighbours) {
        packet.get(neighbour.part);
        packet.get(neighbour.sent);
        packet.get(neighbour.firstCopy);
        packet.get(neighbour.copies);
    }
    part.elimination.pivots = pivotsFrom(packet);
    packet.get(part.sliders);
    return part;
}

}  // namespace

template <int Modes>
DividedLevel<Modes>::DividedLevel(const Team& team, std::vector<int> ownerOf, Aggregates groups,
                                  CoarseSolver<Modes>& next, WorkerPool& workers)
    : m_team(team),
      m_ownerOf(std::move(ownerOf)),
      m_groups(std::move(groups)),
      m_next(next),
      m_workers(workers) {
    for (std::size_t i = 0; i < m_ownerOf.size(); ++i)
        if (m_ownerOf[i] == team.rank()) m_own.push_back(static_cast<int>(i));
}

template <int Modes>
int DividedLevel<Modes>::ownPlace(int number) const {
    return static_cast<int>(std::lower_bound(m_own.begin(), m_own.end(), number) - m_own.begin());
}

/// Returns both triangles of the rows of its own aggregates, to which all processes add in their order.
template <int Modes>
auto DividedLevel<Modes>::exchangeRows(const CoarseShare<Modes>& share) const -> std::vector<Row> {
    using Block = Eigen::Matrix<float, Modes, Modes>;
    using Square = Eigen::Matrix<double, Modes, Modes>;
    struct Entries {
        std::vector<int> rows, columns;
        std::vector<Block> blocks, rests;
    };
    std::vector<Entries> out(static_cast<std::size_t>(m_team.size()));
    const auto add = [&](int row, int column, const Block& block, const Block& rest) {
        Entries& entries = out[m_ownerOf[row]];
        entries.rows.push_back(row);
        entries.columns.push_back(column);
        entries.blocks.push_back(block);
        entries.rests.push_back(rest);
    };
    const Block none = Block::Zero();
    std::size_t next = 0;
    for (std::size_t i = 0; i < share.rows.size(); ++i)
        for (int k = 0; k < share.count[i]; ++k, ++next) {
            const Block &block = share.blocks[next], &rest = share.rests.empty() ? none : share.rests[next];
            add(share.rows[i], share.columns[next], block, rest);
            if (share.columns[next] != share.rows[i])
                add(share.columns[next], share.rows[i], block.transpose(), rest.transpose());
        }
    std::vector<Packet> packets(out.size());
    for (std::size_t rank = 0; rank < out.size(); ++rank) {
        packets[rank].put(out[rank].rows);
        packets[rank].put(out[rank].columns);
        packets[rank].put(out[rank].blocks);
        packets[rank].put(out[rank].rests);
        out[rank] = {};
    }
    std::vector<std::map<int, Square>> sums(m_own.size());
    for (Packet& packet : m_team.exchange(std::move(packets))) {
        Entries entries;
        packet.get(entries.rows);
        packet.get(entries.columns);
        packet.get(entries.blocks);
        packet.get(entries.rests);
        packet = {};
        for (std::size_t i = 0; i < entries.rows.size(); ++i) {
            auto& row = sums[ownPlace(entries.rows[i])];
            Square& sum = row.try_emplace(entries.columns[i], Square::Zero()).first->second;
            sum += entries.blocks[i].template cast<double>() + entries.rests[i].template cast<double>();
        }
    }
    std::vector<Row> rows(m_own.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        for (const auto& [column, block] : sums[i]) {
            rows[i].columns.push_back(column);
            rows[i].blocks.push_back(block.template cast<float>());
        }
        sums[i] = {};
    }
    return rows;
}

/// Lists which rows of its share belong to which process, and which of its own are in whose share.
template <int Modes>
void DividedLevel<Modes>::listUsers(const CoarseShare<Modes>& share) {
    m_touched.assign(static_cast<std::size_t>(m_team.size()), {});
    std::vector<std::vector<int>> numbers(m_touched.size());
    for (std::size_t i = 0; i < share.rows.size(); ++i) {
        m_touched[m_ownerOf[share.rows[i]]].push_back(static_cast<int>(i));
        numbers[m_ownerOf[share.rows[i]]].push_back(share.rows[i]);
    }
    m_touchedBy = m_team.exchange(numbers);
    for (auto& list : m_touchedBy)
        for (int& number : list) number = ownPlace(number);
}

/// Numbers the copies, which are the columns of its rows that are other processes' aggregates.
template <int Modes>
std::vector<Neighbour> DividedLevel<Modes>::number(const std::vector<Row>& rows) {
    std::vector<std::vector<int>> copied(static_cast<std::size_t>(m_team.size()));
    for (const Row& row : rows)
        for (int column : row.columns)
            if (m_ownerOf[column] != m_team.rank()) copied[m_ownerOf[column]].push_back(column);
    for (auto& list : copied) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    const auto sent = m_team.exchange(copied);
    std::vector<Neighbour> neighbours;
    m_copied.clear();
    for (int rank = 0; rank < m_team.size(); ++rank) {
        if (copied[rank].empty() && sent[rank].empty()) continue;
        Neighbour neighbour{rank,
                            {},
                            static_cast<int>(m_own.size() + m_copied.size()),
                            static_cast<int>(copied[rank].size())};
        for (int one : sent[rank]) neighbour.sent.push_back(ownPlace(one));
        neighbours.push_back(std::move(neighbour));
        m_copied.insert(m_copied.end(), copied[rank].begin(), copied[rank].end());
    }
    return neighbours;
}

template <int Modes>
BlockRows<Modes> DividedLevel<Modes>::matrixOf(std::vector<Row> rows, const CoarseShare<Modes>& share) const {
    std::map<int, int> copyOf;
    for (std::size_t i = 0; i < m_copied.size(); ++i)
        copyOf[m_copied[i]] = static_cast<int>(m_own.size() + i);
    std::vector<int> start{0}, columns;
    std::vector<std::vector<std::pair<int, int>>> order(rows.size());  // local column, entry
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < rows[i].columns.size(); ++k) {
            const int number = rows[i].columns[k];
            const bool own = m_ownerOf[number] == m_team.rank();
            order[i].emplace_back(own ? ownPlace(number) : copyOf.at(number), static_cast<int>(k));
        }
        std::sort(order[i].begin(), order[i].end());
        for (const auto& [column, entry] : order[i]) columns.push_back(column);
        start.push_back(static_cast<int>(columns.size()));
    }
    BlockRows<Modes> A;
    A.setPattern(std::move(start), std::move(columns), static_cast<int>(m_own.size() + m_copied.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        int at = A.begin(static_cast<int>(i));
        for (const auto& [column, entry] : order[i]) A.block(at++) = rows[i].blocks[entry];
        rows[i] = {};
    }
    for (std::size_t i = 0; i < share.rows.size(); ++i) {
        if (m_ownerOf[share.rows[i]] != m_team.rank()) continue;
        const int row = ownPlace(share.rows[i]);
        auto block = A.block(A.entryOf(row, row));
        block = (0.5F * (block + block.transpose())).eval();
        for (int k = 0; k < Modes; ++k)
            if (share.missing[i] >> k & 1U) block(k, k) = 1;
    }
    return A;
}

template <int Modes>
BuildStatus DividedLevel<Modes>::build(CoarseShare<Modes> share) {
    m_matrix = {};
    auto rows = exchangeRows(share);
    share.blocks = {};
    share.rests = {};
    listUsers(share);
    m_links.emplace(m_team, m_own, number(rows));
    m_matrix = matrixOf(std::move(rows), share);
    const auto motions = std::move(share.motions);
    share = {};
    const auto status = m_level.build(m_matrix, m_groups, motions, {}, *m_links, m_workers, share);
    return status == BuildStatus::Done ? m_next.build(std::move(share)) : status;
}

/// Sums of right-hand sides run in the order of the processes.
template <int Modes>
bool DividedLevel<Modes>::solve(Points<Modes>& r, Points<Modes>& z) {
    const auto columnsOf = [](const Points<Modes>& from, const std::vector<int>& columns) {
        std::vector<double> values;
        values.reserve(columns.size() * Modes);
        for (int column : columns)
            values.insert(values.end(), from.col(column).begin(), from.col(column).end());
        return values;
    };
    const auto forColumns = [](const std::vector<double>& values, const std::vector<int>& columns,
                               auto&& visit) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            visit(columns[i], Eigen::Map<const Vec<Modes>>(values.data() + i * Modes));
    };
    std::vector<std::vector<double>> out(m_touched.size());
    for (std::size_t rank = 0; rank < out.size(); ++rank) out[rank] = columnsOf(r, m_touched[rank]);
    auto in = m_team.exchange(out, m_touchedBy, Modes);
    m_r.setZero(Modes, m_matrix.columns());
    for (std::size_t rank = 0; rank < in.size(); ++rank)
        forColumns(in[rank], m_touchedBy[rank], [&](int row, const auto& value) { m_r.col(row) += value; });
    const auto solveNext = [this](const Points<Modes>& right, Points<Modes>& result) {
        m_nextRight = right;
        return m_next.solve(m_nextRight, result);
    };
    if (!m_level.cycle(m_matrix, m_r, m_z, solveNext, *m_links, m_workers)) return false;
    for (std::size_t rank = 0; rank < out.size(); ++rank) out[rank] = columnsOf(m_z, m_touchedBy[rank]);
    in = m_team.exchange(out, m_touched, Modes);
    z.resizeLike(r);
    for (std::size_t rank = 0; rank < in.size(); ++rank)
        forColumns(in[rank], m_touched[rank], [&](int row, const auto& value) { z.col(row) = value; });
    return true;
}

template class DividedLevel<6>;
template class DividedLevel<12>;

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

template <int Dim>
void PartTask<Dim>::put(Packet& packet) const {
    putPart(part, packet);
    putPoints<Dim>(rest, packet);
    packet.put(material.phi);
    packet.put(material.anisotropy);
    packet.put(material.smoothing);
    packet.put(material.memory);
    packet.put(epsilon);
    packet.put(aggregates.count);
    packet.put(aggregates.of);
    packet.put(ownerOf);
    packet.put(groups.count);
    packet.put(groups.of);
    packet.put(threads);
}

template <int Dim>
PartTask<Dim> PartTask<Dim>::from(Packet& packet) {
    PartTask task;
    task.part = partFrom<Dim>(packet);
    task.rest = pointsFrom<Dim>(packet);
    packet.get(task.material.phi);
    packet.get(task.material.anisotropy);
    packet.get(task.material.smoothing);
    packet.get(task.material.memory);
    packet.get(task.epsilon);
    packet.get(task.aggregates.count);
    packet.get(task.aggregates.of);
    packet.get(task.ownerOf);
    packet.get(task.groups.count);
    packet.get(task.groups.of);
    packet.get(task.threads);
    return task;
}

template <int Dim>
PartSolver<Dim>::PartSolver(const Team& team, PartTask<Dim> task)
    : m_team(team),
      m_own(task.part.own),
      m_cells(std::move(task.part.cells)),
      m_followers(std::move(task.part.followers)),
      m_epsilon(std::move(task.epsilon)),
      m_links(team, std::move(task.part.unknowns), std::move(task.part.neighbours)),
      m_rest(std::make_shared<const SimplicialMesh<Dim>>(
          SimplicialMesh<Dim>{std::move(task.rest), std::move(task.part.corners)})),
      m_plan(std::make_shared<const AssemblyPlan<Dim>>(makeAssemblyPlan(
          *m_rest, task.material.smoothing.kind != SmoothingKind::None, Contributions::Left))),
      m_system(*m_plan, task.part.elimination, task.part.sliders),
      m_backEnd(makeCpuBackEnd<Dim>(m_plan, *m_rest, task.material, task.threads)),
      m_gathered(team, std::move(task.gathered), m_backEnd->workers()),
      m_multigrid(*m_backEnd, m_system, m_links, coarse(task)) {
    m_multigrid.analyze(*m_plan, std::move(task.aggregates));
    m_backEnd->setMassRegularization(m_epsilon);
}

template <int Dim>
CoarseSolver<Multigrid<Dim>::kModes>& PartSolver<Dim>::coarse(PartTask<Dim>& task) {
    if (task.ownerOf.empty()) return m_gathered;
    return m_coarse.emplace(m_team, std::move(task.ownerOf), std::move(task.groups), m_gathered,
                            m_backEnd->workers());
}

template <int Dim>
int PartSolver<Dim>::setShape(Points<Dim> shape) {
    constexpr int kNone = std::numeric_limits<int>::max();
    const int cell = m_backEnd->setShape(shape);
    m_shape = std::make_shared<const Points<Dim>>(std::move(shape));
    int first = kNone;
    for (int one : m_team.all(cell < 0 ? kNone : m_cells[cell])) first = std::min(first, one);
    return first == kNone ? -1 : first;
}

template <int Dim>
BuildStatus PartSolver<Dim>::build(const std::stop_token& stop, const WorkerPool::Progress& progress) {
    const WorkerPool::Watched watched(m_backEnd->workers(), stop, progress);
    return m_multigrid.build(*m_shape);
}

template <int Dim>
typename PartSolver<Dim>::Result PartSolver<Dim>::run(const Goal& goal, const Points<Dim>* load,
                                                      Points<Dim>& v) {
    const auto precondition = [this](std::span<const double> r, std::span<double> z) {
        return m_multigrid.apply(r, z);
    };
    const WorkerPool::Watched watched(m_backEnd->workers(), goal.stop);
    return m_iteration.run(*m_backEnd, m_system, precondition, goal, load, v, m_links);
}

/// Returns E(v) = vᵀ A v, without the mass.
template <int Dim>
double PartSolver<Dim>::energy(const Points<Dim>& v) {
    Points<Dim> Av;
    if (!m_epsilon.empty()) {
        m_backEnd->setMassRegularization({});
        m_backEnd->setShape(*m_shape);
    }
    m_backEnd->apply(v, Av);
    if (!m_epsilon.empty()) {
        m_backEnd->setMassRegularization(m_epsilon);
        m_backEnd->setShape(*m_shape);
    }
    double part = v.leftCols(m_own).cwiseProduct(Av.leftCols(m_own)).sum();
    for (int vertex : m_followers) part += v.col(vertex).dot(Av.col(vertex));
    return m_links.sum(part);
}

template struct PartTask<2>;
template struct PartTask<3>;
template class PartSolver<2>;
template class PartSolver<3>;

}  // namespace wend
