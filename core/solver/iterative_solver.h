#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/assembly/back_end.h"
#include "core/solver/conjugate_gradients.h"
#include "core/solver/reduced_system.h"

namespace wend {

/// Says how building the levels of multigrid ended.
enum class BuildStatus { Done, NotPositiveDefinite, Stopped };

/// Solves the systems of one mesh by conjugate gradients with multigrid, for one set of constraints after
/// another, in this process or divided among several. One thread uses it at a time.
template <int Dim>
class IterativeSolver {
  public:
    using Goal = typename ConjugateGradients<Dim>::Goal;
    using Result = typename ConjugateGradients<Dim>::Result;

    virtual ~IterativeSolver() = default;

    /// Returns about how many bytes it takes.
    virtual double needed() const { return 0; }
    /// Returns the back end that applies the matrix; it does not assemble it.
    virtual BackEnd<Dim>& backEnd() = 0;
    /// Prepares everything that follows from cells and the present system alone, and passes epsilon on to
    /// BackEnd::setMassRegularization().
    virtual void analyze(std::vector<double> epsilon) = 0;
    /// Builds all levels at a shape, which is the back end's.
    virtual BuildStatus build(Nodal<Dim> shape, const std::stop_token& stop,
                              const WorkerPool::Progress& progress) = 0;
    /// Does ConjugateGradients::run() with these levels, at the back end's shape.
    virtual Result run(const Goal& goal, const Points<Dim>* load, Points<Dim>& v) = 0;
};

/// The task of an iterative solver: a plan, its normalized rest mesh, a valid material, and the system, which
/// changes with the constraints; threads as in BackEndFactory. The references must outlive the solver.
template <int Dim>
struct SolverTask {
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    const Material<Dim>& material;
    const ReducedSystem<Dim>& system;
    int threads;
};

/// Makes an iterative solver for a task, in this process or divided among several.
template <int Dim>
using IterativeSolverFactory = std::function<std::unique_ptr<IterativeSolver<Dim>>(const SolverTask<Dim>&)>;

/// Makes a solver in this process. Throws NotEnoughMemory if the machine lacks the memory for it.
template <int Dim>
std::unique_ptr<IterativeSolver<Dim>> makeMultigridSolver(const SolverTask<Dim>& task);

}  // namespace wend
