#include "mpi/divided_solver.h"

#include <petscmat.h>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "mpi/division.h"
#include "mpi/part_solver.h"

namespace wend {

namespace {

/// PETSc frees it with the object that it is given to.
PetscInt* copyForPetsc(const std::vector<int>& list) {
    PetscInt* copy = nullptr;
    if (PetscMalloc1(list.size() + 1, &copy) != 0) throw std::bad_alloc();
    std::copy(list.begin(), list.end(), copy);
    return copy;
}

PetscErrorCode partition(const WeightedGraph& graph, int parts, std::vector<int>& partOf) {
    const PetscInt nodes = graph.nodes();
    ::Mat adjacency = nullptr;
    PetscCall(MatCreateMPIAdj(PETSC_COMM_SELF, nodes, nodes, copyForPetsc(graph.start),
                              copyForPetsc(graph.neighbour), copyForPetsc(graph.edgeWeight), &adjacency));
    MatPartitioning partitioning = nullptr;
    PetscCall(MatPartitioningCreate(PETSC_COMM_SELF, &partitioning));
    PetscCall(MatPartitioningSetAdjacency(partitioning, adjacency));
    PetscCall(MatPartitioningSetType(partitioning, MATPARTITIONINGPTSCOTCH));
    PetscCall(MatPartitioningSetVertexWeights(partitioning, copyForPetsc(graph.nodeWeight)));
    PetscCall(MatPartitioningSetUseEdgeWeights(partitioning, PETSC_TRUE));
    PetscCall(MatPartitioningSetNParts(partitioning, parts));
    IS result = nullptr;
    PetscCall(MatPartitioningApply(partitioning, &result));
    const PetscInt* indices = nullptr;
    PetscCall(ISGetIndices(result, &indices));
    partOf.assign(indices, indices + nodes);
    PetscCall(ISRestoreIndices(result, &indices));
    PetscCall(ISDestroy(&result));
    PetscCall(MatPartitioningDestroy(&partitioning));
    PetscCall(MatDestroy(&adjacency));
    return 0;
}

/// Divides the nodes of a graph into parts of nearly equal weight with few edges between them, by PT-Scotch
/// through PETSc: the part of every node. Throws std::runtime_error.
std::vector<int> partitionOf(const WeightedGraph& graph, int parts) {
    std::vector<int> partOf(graph.nodeWeight.size(), 0);
    if (parts == 1 || graph.nodes() <= parts) {
        for (std::size_t i = 0; i < partOf.size(); ++i) partOf[i] = static_cast<int>(i) % parts;
        return partOf;
    }
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
    const PetscErrorCode code = partition(graph, parts, partOf);
    PetscPopErrorHandler();
    if (code != 0)
        throw std::runtime_error("the mesh cannot be divided: PETSc reports error " + std::to_string(code));
    return partOf;
}

constexpr int kGroupsOfProcess = 4;  // or more, so that parts are about equal

enum class Command { Divide, SetShape, Build, Run, Energy, Close, End };

/// The numbers of a goal; its functions stay in the first process.
struct GoalNumbers {
    double tolerance, contraction, minContraction, poorestContraction;
    int trials, most;
    bool cautious, hasLoad;

    template <class Goal>
    void set(Goal& goal) const {
        goal.tolerance = tolerance;
        goal.contraction = contraction;
        goal.minContraction = minContraction;
        goal.poorestContraction = poorestContraction;
        goal.trials = trials;
        goal.most = most;
        goal.cautious = cautious;
    }
};

/// The work of a process other than the first for one solver.
class Service {
  public:
    virtual ~Service() = default;
    virtual void serve(Command command, Packet& order) = 0;
};

template <int Dim>
class PartService final : public Service {
  public:
    explicit PartService(const Team& team) : m_team(team) {}

    void serve(Command command, Packet& order) override {
        switch (command) {
            case Command::Divide:
                return divide();
            case Command::SetShape:
                m_part->setShape(received());
                return;
            case Command::Build:
                m_part->build({}, {});
                return;
            case Command::Run:
                return run(order);
            case Command::Energy:
                m_part->energy(received());
                return;
            case Command::Close:
            case Command::End:
                return;
        }
    }

  private:
    void divide() {
        m_part.reset();
        Packet packet = m_team.receive(0);
        m_team.together(
            [&] { m_part = std::make_unique<PartSolver<Dim>>(m_team, PartTask<Dim>::from(packet)); });
    }

    Points<Dim> received() const {
        Points<Dim> values(Dim, m_part->vertices());
        m_team.receive(0, {values.data(), static_cast<std::size_t>(values.size())});
        return values;
    }

    void run(Packet& order) {
        GoalNumbers numbers{};
        order.get(numbers);
        typename PartSolver<Dim>::Goal goal;
        numbers.set(goal);
        Points<Dim> v = received(), load;
        if (numbers.hasLoad) load = received();
        m_part->run(goal, numbers.hasLoad ? &load : nullptr, v);
        m_team.send(0, {v.data(), static_cast<std::size_t>(m_part->own()) * Dim});
    }

    const Team& m_team;
    std::unique_ptr<PartSolver<Dim>> m_part;
};

void order(const Team& team, Command command, int solver, int dimension, Packet rest = {}) {
    Packet packet;
    packet.put(command);
    packet.put(solver);
    packet.put(dimension);
    packet.bytes().insert(packet.bytes().end(), rest.bytes().begin(), rest.bytes().end());
    team.broadcast(packet);
}

/// Conjugate gradients and multigrid in all processes of a team; this object is in the first one.
template <int Dim>
class DividedSolver final : public IterativeSolver<Dim> {
  public:
    using typename IterativeSolver<Dim>::Goal;
    using typename IterativeSolver<Dim>::Result;

    DividedSolver(const Team& team, const SolverTask<Dim>& task);
    ~DividedSolver() override { order(m_team, Command::Close, m_number, Dim); }

    BackEnd<Dim>& backEnd() override { return m_backEnd; }
    void analyze(std::vector<double> epsilon) override;
    BuildStatus build(Nodal<Dim> shape, const std::stop_token& stop,
                      const WorkerPool::Progress& progress) override;
    Result run(const Goal& goal, const Points<Dim>* load, Points<Dim>& v) override;

  private:
    /// Computes in all processes.
    class DividedBackEnd final : public BackEnd<Dim> {
      public:
        explicit DividedBackEnd(DividedSolver& solver) : m_solver(solver), m_workers(solver.m_threads) {}

        std::string name() const override { return "cpu"; }
        std::string device() const override;
        void setMassRegularization(std::vector<double>) override {}  // that of analyze()
        int setShape(const Points<Dim>& shape) override { return m_solver.setShape(shape); }
        WorkerPool& workers() override { return m_workers; }
        void assemble(std::span<double>) override { throw std::logic_error("the matrix is divided"); }
        void apply(const Points<Dim>&, Points<Dim>&) override {
            throw std::logic_error("the matrix is divided");
        }
        double energy(const Points<Dim>& v) override { return m_solver.energy(v); }

      private:
        DividedSolver& m_solver;
        WorkerPool m_workers;
    };

    struct Levels {
        Aggregates aggregates, groups;  // of the unknowns; of the aggregates, where these are divided, too
        Graph gathered;                 // the aggregates of the first level that is not divided
    };
    PartTask<Dim> taskOf(Part<Dim> part, const std::vector<double>& epsilon, const Levels& levels,
                         const std::vector<int>& aggregateOwners) const;
    Levels levels() const;
    std::vector<int> owners(const Levels& levels) const;
    int setShape(const Points<Dim>& shape);
    double energy(const Points<Dim>& v);
    void scatter(const Points<Dim>& whole) const;
    void gather(const Points<Dim>& own, Points<Dim>& v) const;

    const Team& m_team;
    int m_number;
    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    std::shared_ptr<const SimplicialMesh<Dim>> m_rest;
    Material<Dim> m_material;
    const ReducedSystem<Dim>& m_system;
    int m_threads;
    DividedBackEnd m_backEnd;

    struct Extent {
        int own;
        std::vector<int> vertices;
    };
    std::vector<Extent> m_parts;
    std::vector<int> m_unknownOf;  // per vertex
    std::unique_ptr<PartSolver<Dim>> m_part;
};

int nextNumber() {
    static int number = 0;
    return ++number;
}

template <int Dim>
DividedSolver<Dim>::DividedSolver(const Team& team, const SolverTask<Dim>& task)
    : m_team(team),
      m_number(nextNumber()),
      m_plan(task.plan),
      m_rest(task.rest),
      m_material(task.material),
      m_system(task.system),
      m_threads(std::max(task.threads, 1)),
      m_backEnd(*this) {}

template <int Dim>
std::string DividedSolver<Dim>::DividedBackEnd::device() const {
    const int processes = m_solver.m_team.size(), threads = m_solver.m_threads;
    return std::to_string(processes) + (processes == 1 ? " process" : " processes") +
           (threads == 1 ? "" : " of " + std::to_string(threads) + " threads");
}

/// Returns the groups of all levels that may be divided. The first coarse level is divided, too, if the next
/// one has enough groups for all processes; each part then has whole groups.
template <int Dim>
auto DividedSolver<Dim>::levels() const -> Levels {
    constexpr int kModes = Multigrid<Dim>::kModes;
    Levels levels;
    const Graph graph = graphOf<Dim>(*m_plan, m_system);
    levels.aggregates = aggregatesOf(graph);
    levels.gathered = quotient(graph, levels.aggregates);
    if (levels.gathered.size() * kModes <= CoarseLevels<kModes>::kFactored || m_team.size() == 1)
        return levels;
    Aggregates groups = aggregatesOf(levels.gathered);
    if (groups.count < kGroupsOfProcess * m_team.size()) return levels;
    levels.gathered = quotient(levels.gathered, groups);
    levels.groups = std::move(groups);
    return levels;
}

/// Returns the part of every unknown vertex.
template <int Dim>
std::vector<int> DividedSolver<Dim>::owners(const Levels& levels) const {
    std::vector<int> groupOf(m_plan->vertexCount, -1);
    const bool twice = levels.groups.count > 0;
    for (std::size_t i = 0; i < levels.aggregates.of.size(); ++i) {
        const int aggregate = levels.aggregates.of[i];
        groupOf[m_system.unknowns()[i]] = twice ? levels.groups.of[aggregate] : aggregate;
    }
    const int groups = twice ? levels.groups.count : levels.aggregates.count;
    const std::vector<int> partOf = partitionOf(groupGraph<Dim>(*m_plan, groupOf, groups), m_team.size());
    for (int& group : groupOf)
        if (group >= 0) group = partOf[group];
    return groupOf;
}

template <int Dim>
PartTask<Dim> DividedSolver<Dim>::taskOf(Part<Dim> part, const std::vector<double>& epsilon,
                                         const Levels& levels,
                                         const std::vector<int>& aggregateOwners) const {
    PartTask<Dim> task;
    task.aggregates.count = levels.aggregates.count;
    for (int unknown : part.unknowns) task.aggregates.of.push_back(levels.aggregates.of[unknown]);
    if (levels.groups.count > 0) {
        task.ownerOf = aggregateOwners;
        task.groups.count = levels.groups.count;
        for (std::size_t i = 0; i < aggregateOwners.size(); ++i)
            if (aggregateOwners[i] == part.number) task.groups.of.push_back(levels.groups.of[i]);
    }
    task.rest = gathered<Dim>(m_rest->points, part.vertices);
    task.material.smoothing = m_material.smoothing;
    task.material.memory = m_material.memory;
    for (int cell : part.cells) {
        task.material.phi.push_back(m_material.phi[cell]);
        if (!m_material.anisotropy.empty()) task.material.anisotropy.push_back(m_material.anisotropy[cell]);
        if (!epsilon.empty()) task.epsilon.push_back(epsilon[cell]);
    }
    task.threads = m_threads;
    task.part = std::move(part);
    return task;
}

template <int Dim>
void DividedSolver<Dim>::analyze(std::vector<double> epsilon) {
    if (m_system.sliders().areGuided())
        throw InputError(
            "a handle slides on a surface, which only one process can solve for: use `wend run`");
    m_part.reset();
    m_parts.clear();
    m_unknownOf.assign(m_plan->vertexCount, -1);
    for (std::size_t i = 0; i < m_system.unknowns().size(); ++i)
        m_unknownOf[m_system.unknowns()[i]] = static_cast<int>(i);
    Levels levels = this->levels();
    const std::vector<int> ownerOf = owners(levels);
    std::vector<int> aggregateOwners(static_cast<std::size_t>(levels.aggregates.count));
    for (std::size_t i = 0; i < levels.aggregates.of.size(); ++i)
        aggregateOwners[levels.aggregates.of[i]] = ownerOf[m_system.unknowns()[i]];
    auto parts = allParts<Dim>(Division<Dim>(*m_plan, m_system, ownerOf, m_team.size()));
    for (const auto& part : parts) m_parts.push_back({part.own, part.vertices});
    order(m_team, Command::Divide, m_number, Dim);
    for (int rank = 1; rank < m_team.size(); ++rank) {
        Packet packet;
        taskOf(std::move(parts[rank]), epsilon, levels, aggregateOwners).put(packet);
        m_team.send(rank, packet);
    }
    m_team.together([&] {
        auto own = taskOf(std::move(parts[0]), epsilon, levels, aggregateOwners);
        own.gathered = std::move(levels.gathered);
        m_part = std::make_unique<PartSolver<Dim>>(m_team, std::move(own));
    });
}

/// Sends every other process the columns of its part.
template <int Dim>
void DividedSolver<Dim>::scatter(const Points<Dim>& whole) const {
    for (int rank = 1; rank < m_team.size(); ++rank) {
        const Points<Dim> part = gathered<Dim>(whole, m_parts[rank].vertices);
        m_team.send(rank, {part.data(), static_cast<std::size_t>(part.size())});
    }
}

/// Gathers the new velocities of all unknowns, and computes the others from them.
template <int Dim>
void DividedSolver<Dim>::gather(const Points<Dim>& own, Points<Dim>& v) const {
    Points<Dim> added(Dim, static_cast<Eigen::Index>(m_system.unknowns().size())), received;
    for (int rank = 0; rank < m_team.size(); ++rank) {
        const Extent& part = m_parts[rank];
        if (rank > 0) {
            received.resize(Dim, part.own);
            m_team.receive(rank, {received.data(), static_cast<std::size_t>(received.size())});
        }
        const Points<Dim>& from = rank == 0 ? own : received;
        for (int i = 0; i < part.own; ++i)
            added.col(m_unknownOf[part.vertices[i]]) = from.col(i) - v.col(part.vertices[i]);
    }
    m_system.expand(added, v);
}

template <int Dim>
int DividedSolver<Dim>::setShape(const Points<Dim>& shape) {
    order(m_team, Command::SetShape, m_number, Dim);
    scatter(shape);
    return m_part->setShape(gathered<Dim>(shape, m_parts[0].vertices));
}

template <int Dim>
BuildStatus DividedSolver<Dim>::build(Nodal<Dim>, const std::stop_token& stop,
                                      const WorkerPool::Progress& progress) {
    order(m_team, Command::Build, m_number, Dim);
    return m_part->build(stop, progress);
}

template <int Dim>
typename DividedSolver<Dim>::Result DividedSolver<Dim>::run(const Goal& goal, const Points<Dim>* load,
                                                            Points<Dim>& v) {
    Packet numbers;
    numbers.put(GoalNumbers{goal.tolerance, goal.contraction, goal.minContraction, goal.poorestContraction,
                            goal.trials, goal.most, goal.cautious, load != nullptr});
    order(m_team, Command::Run, m_number, Dim, std::move(numbers));
    scatter(v);
    if (load) scatter(*load);
    Points<Dim> own = gathered<Dim>(v, m_parts[0].vertices), ownLoad;
    if (load) ownLoad = gathered<Dim>(*load, m_parts[0].vertices);
    const Result result = m_part->run(goal, load ? &ownLoad : nullptr, own);
    gather(own, v);
    return result;
}

template <int Dim>
double DividedSolver<Dim>::energy(const Points<Dim>& v) {
    order(m_team, Command::Energy, m_number, Dim);
    scatter(v);
    return m_part->energy(gathered<Dim>(v, m_parts[0].vertices));
}

}  // namespace

template <int Dim>
IterativeSolverFactory<Dim> dividedSolvers(const Team& team) {
    return [&team](const SolverTask<Dim>& task) { return std::make_unique<DividedSolver<Dim>>(team, task); };
}

template IterativeSolverFactory<2> dividedSolvers<2>(const Team&);
template IterativeSolverFactory<3> dividedSolvers<3>(const Team&);

void serve(const Team& team) {
    std::map<int, std::unique_ptr<Service>> services;
    while (true) {
        Packet packet;
        team.broadcast(packet);
        Command command{};
        int solver = 0, dimension = 0;
        packet.get(command);
        packet.get(solver);
        packet.get(dimension);
        if (command == Command::End) return;
        auto& service = services[solver];
        if (!service && dimension == 2) service = std::make_unique<PartService<2>>(team);
        if (!service) service = std::make_unique<PartService<3>>(team);
        try {
            service->serve(command, packet);
        } catch (const Abandoned&) {  // the first process reports the reason and continues
        }
        if (command == Command::Close) services.erase(solver);
    }
}

void dismiss(const Team& team) {
    order(team, Command::End, 0, 0);
}

}  // namespace wend
