#pragma once

#include "core/assembly/rest_energy.h"
#include "core/solver/cholesky.h"
#include "core/solver/conjugate_gradients.h"
#include "core/solver/projection.h"
#include "core/solver/reduced_system.h"
#include "core/solver/supernodal_factor.h"
#include "core/solver/velocity_solver.h"
#include "core/solver/vertex_rotations.h"

namespace wend {

/// What the velocity solver keeps from one solve to the next: the parts of the method, and the factor at
/// hand.
template <int Dim>
struct VelocitySolver<Dim>::Engine {
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const AssemblyPlan<Dim>> plan;
    std::unique_ptr<BackEnd<Dim>> backEnd;
    std::vector<int> components;

    std::vector<ConstraintRow> rows;
    Sliders givenSliders;
    Sliders sliders;  // without those that are pivots
    bool analyzed = false;
    Elimination elimination;
    Projection<Dim> projection;
    ReducedSystem<Dim> system;
    Cholesky cholesky;
    // Made at the first use.
    std::optional<SupernodalFactor<float>> singleFactor;
    std::optional<SupernodalFactor<double>> doubleFactor;

    Material<Dim> material;
    std::optional<RestEnergy<Dim>> restEnergy;  // made at the first use
    double memoryRate = 0;
    Points<Dim> load;  // ½ memoryRate ∇W of the solve that goes on; no columns: none

    std::vector<double> blocks;  // of A
    SolverStatistics statistics;

    bool reusable = false, turns = false;           // by the material
    std::optional<VertexRotations<Dim>> rotations;  // made at the first use
    bool turned = false;                            // the factor at hand stands turned
    std::vector<double> turnedRight;
    double tolerance = 0;
    std::stop_token stop;
    // Where the factor that serves was made and in which precision, if single is too little here, and the
    // contraction of a first iteration with the lag at which it was measured. Its counts are the policy's.
    FactorMemory<Dim> memory;
    Nodal<Dim> held;  // where the factor at hand was made
    FactorKind heldKind = FactorKind::Reference;
    RefactorPolicy policy;
    ConjugateGradients<Dim> iteration;
    Points<Dim> last;  // v̂ of the last solve

    Engine(std::shared_ptr<const SimplicialMesh<Dim>> mesh, const Material<Dim>& stuff,
           const BackEndFactory<Dim>& makeBackEnd, int threads);
    void setConstraints(std::vector<ConstraintRow> newRows, Sliders newSliders = {});
    void countCosts();
    RestEnergy<Dim>& rested();
    void computeLoad();
    const Points<Dim>* loadOrNull() const { return load.cols() > 0 ? &load : nullptr; }
    SolveOutcome solve(const Points<Dim>& prescribed, Points<Dim>& v,
                       const std::optional<Points<Dim>>& guess);
    bool reuses() const;
    SolveOutcome factorize();
    SolveOutcome factorizeAt(const Nodal<Dim>& shape, FactorKind kind);
    bool factorizes(FactorKind kind);
    bool solveWithFactor(std::span<const double> b, std::span<double> x);
    double expectedContraction(double lag) const;
    double minContraction() const;
    void learnContraction(double lag, const typename ConjugateGradients<Dim>::Result& result);
    bool makeFactorAgain();
    bool precondition(std::span<const double> r, std::span<double> z);
    bool iterate(Points<Dim>& v);
    SolveOutcome solveDirectly(Points<Dim>& v);
    SolveOutcome solveReduced(Points<Dim>& v);
};

}  // namespace wend
