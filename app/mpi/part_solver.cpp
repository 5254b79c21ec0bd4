#include "app/mpi/part_solver.h"

#include <limits>

#include "core/assembly/cpu_back_end.h"

namespace wend {
namespace {

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
