#include "core/assembly/cpu_back_end.h"
#include "core/base/memory.h"
#include "core/solver/iterative_solver.h"
#include "core/solver/multigrid/multigrid.h"
#include "core/solver/solver_choice.h"

namespace wend {
namespace {

template <int Dim>
class MultigridSolver final : public IterativeSolver<Dim> {
  public:
    using typename IterativeSolver<Dim>::Goal;
    using typename IterativeSolver<Dim>::Result;

    explicit MultigridSolver(const SolverTask<Dim>& task)
        : m_plan(task.plan),
          m_system(task.system),
          m_backEnd(makeCpuBackEnd<Dim>(task.plan, *task.rest, task.material, task.threads)),
          m_coarse(m_backEnd->workers()),
          m_multigrid(*m_backEnd, m_system, m_links, m_coarse) {
        requireMemory(needed());
    }

    double needed() const override { return multigridBytes(Dim, m_plan->vertexCount); }

    BackEnd<Dim>& backEnd() override { return *m_backEnd; }

    void analyze(std::vector<double> epsilon) override {
        const Graph graph = graphOf<Dim>(*m_plan, m_system);
        auto aggregates = aggregatesOf(graph);
        m_coarse.analyze(quotient(graph, aggregates));
        m_multigrid.analyze(*m_plan, std::move(aggregates));
        m_backEnd->setMassRegularization(std::move(epsilon));
    }

    BuildStatus build(Nodal<Dim> shape, const std::stop_token& stop,
                      const WorkerPool::Progress& progress) override {
        const WorkerPool::Watched watched(m_backEnd->workers(), stop, progress);
        return m_multigrid.build(*shape);
    }

    Result run(const Goal& goal, const Points<Dim>* load, Points<Dim>& v) override {
        const auto precondition = [this](std::span<const double> r, std::span<double> z) {
            return m_multigrid.apply(r, z);
        };
        const WorkerPool::Watched watched(m_backEnd->workers(), goal.stop);
        return m_iteration.run(*m_backEnd, m_system, precondition, goal, load, v);
    }

  private:
    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    const ReducedSystem<Dim>& m_system;
    std::unique_ptr<BackEnd<Dim>> m_backEnd;
    PartLinks m_links;
    CoarseLevels<Multigrid<Dim>::kModes> m_coarse;
    Multigrid<Dim> m_multigrid;
    ConjugateGradients<Dim> m_iteration;
};

}  // namespace

template <int Dim>
std::unique_ptr<IterativeSolver<Dim>> makeMultigridSolver(const SolverTask<Dim>& task) {
    return std::make_unique<MultigridSolver<Dim>>(task);
}

template std::unique_ptr<IterativeSolver<2>> makeMultigridSolver(const SolverTask<2>&);
template std::unique_ptr<IterativeSolver<3>> makeMultigridSolver(const SolverTask<3>&);

}  // namespace wend
