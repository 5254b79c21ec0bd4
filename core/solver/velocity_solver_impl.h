#pragma once

#include "core/assembly/rest_energy.h"
#include "core/solver/components.h"
#include "core/solver/conjugate_gradients.h"
#include "core/solver/factor_cache.h"
#include "core/solver/projection.h"
#include "core/solver/reduced_system.h"
#include "core/solver/rest_minimizer.h"
#include "core/solver/velocity_solver.h"
#include "core/solver/vertex_rotations.h"

namespace wend {

/// Holds what the velocity solver keeps from one solve to the next: the parts of the method.
template <int Dim>
struct VelocitySolver<Dim>::Impl {
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    std::unique_ptr<BackEnd<Dim>> ownBackEnd;  // of the direct solver
    BackEnd<Dim>* backEnd = nullptr;           // that, or multigrid's
    std::vector<int> components;

    std::vector<ConstraintRow> rows;  // those that were set, then those of welds
    Sliders givenSliders;
    bool constrained = false;  // rows were set
    Elimination elimination;
    Projection<Dim> projection;
    ReducedSystem<Dim> system;
    std::unique_ptr<IterativeSolver<Dim>> multigrid;  // of the system above; null: direct
    std::optional<FactorCache<Dim>> cache;            // always; of the back end and the system above

    Material<Dim> material;
    std::optional<RestEnergy<Dim>> restEnergy;  // made at the first use
    double memoryRate = 0;
    Points<Dim> load;  // ½ memoryRate ∇W of the running solve; no columns: none

    /// W alone has a smaller pattern: of a vertex and those that share a cell with it.
    struct Tracking {
        std::shared_ptr<const AssemblyPlan<Dim>> plan;
        RestEnergy<Dim> energy;
        ReducedSystem<Dim> system;
        std::optional<RestMinimizer<Dim>> minimizer;
    };
    std::unique_ptr<Tracking> tracking;            // these three for the constraints that are set
    std::optional<RestMinimizer<Dim>> descending;  // with the proximal term
    std::optional<ProximalTerm<Dim>> proximal;
    typename RestMinimizer<Dim>::Pace pace = RestMinimizer<Dim>::Pace::Exact;  // of predict()
    std::vector<double> massRegularization;                                    // per cell, or empty
    std::vector<LooseGroup> loose;  // an elastic shape is carried by their rows without a turn

    SolverStatistics statistics;

    bool reusable = false, turns = false;                           // by the material
    std::optional<VertexRotations<Dim>> rotations, fieldRotations;  // made at the first use
    Nodal<Dim> turnedFrom, turnedTo;                                // between which the first are
    std::vector<double> turnedRight;
    double tolerance = 0;
    std::stop_token stop;
    FieldProgress progress;
    ConjugateGradients<Dim> iteration;
    Points<Dim> last;  // v̂ of the last solve

    Impl(std::shared_ptr<const SimplicialMesh<Dim>> mesh, const Material<Dim>& stuff,
         const BackEndFactory<Dim>& makeBackEnd, int threads, SolverKind solver,
         const IterativeSolverFactory<Dim>& makeMultigrid);
    bool isMultigrid() const { return multigrid != nullptr; }
    void setConstraints(std::vector<ConstraintRow> newRows, Sliders newSliders = {});
    Points<Dim> withWelds(const Points<Dim>& given) const;
    bool analyze();
    RestEnergy<Dim>& rested();
    RestMinimizer<Dim>& minimizer();
    int setProximal(double weight, const Points<Dim>& origin);
    void computeLoad();
    const Points<Dim>* loadOrNull() const { return load.cols() > 0 ? &load : nullptr; }
    SolveOutcome solve(const Points<Dim>& given, Points<Dim>& v, const std::optional<Points<Dim>>& guess);
    bool reuses() const;
    typename FactorCache<Dim>::Use use() const;
    void turn(const Points<Dim>& from, const Points<Dim>& to, std::vector<Points<Dim>>& fields);
    void turnFactor();
    bool iterate(Points<Dim>& v);
    typename ConjugateGradients<Dim>::Result iterateWithFactor(
        const typename ConjugateGradients<Dim>::Goal& goal, bool turned, Points<Dim>& v);
    SolveOutcome solveAnew(const Points<Dim>& prescribed, Points<Dim>& v, const Points<Dim>* velocity);
    SolveOutcome solveDirectly(Points<Dim>& v);
    SolveOutcome solveReduced(Points<Dim>& v);
};

}  // namespace wend
