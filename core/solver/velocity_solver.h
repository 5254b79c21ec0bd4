#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/assembly/back_end.h"
#include "core/factor/factor_kind.h"
#include "core/solver/constraint_rows.h"
#include "core/solver/field_progress.h"
#include "core/solver/iterative_solver.h"
#include "core/solver/refactor_policy.h"
#include "core/solver/solver_choice.h"

namespace wend {

/// How a solve ended. A numerical outcome is a value, never an exception.
struct SolveOutcome {
    enum class Kind { Done, CellInverted, NotPositiveDefinite, NotFinite, NotConverged, Stopped };
    Kind kind = Kind::Done;
    int cell = -1;  // CellInverted: the first cell that is flat or turned over

    bool done() const { return kind == Kind::Done; }
};

struct SolverStatistics {
    double analyze = 0, assemble = 0, factor = 0, solve = 0;  // seconds
    int analyses = 0, factorizations = 0, iterations = 0;     // iterations: pairs of triangular solves
    double needed = 0;                                        // bytes of the largest factor, or of multigrid
};

/// What the next solves depend on beside their own arguments: at which shape the factor was made that they
/// start from, and the counts by which it is kept. With it a solver goes on to the same bits as the one that
/// it was taken from. Cheap to copy.
template <int Dim>
struct FactorMemory {
    Nodal<Dim> shape;       // null: the next solve factorizes
    Nodal<Dim> turned;      // to which it was turned last, if it was
    Nodal<Dim> directions;  // of guided sliders; null: there are none
    FactorKind kind = FactorKind::Single, best = FactorKind::Single;  // best: that does not fail here
    // Measured contractions of an iteration, if they were: with the factor so far from its shape, and with
    // one in single precision at its own shape.
    std::optional<double> contraction;
    double contractionLag = 0;
    // How far ahead of the shape at which it was made the factor's is, and how far from it the last one that
    // was solved for: greatest differences of a coordinate.
    double ahead = 0, lag = 0;
    std::optional<double> freshContraction;
    RefactorPolicy::Counts counts;

    template <class Archive>
    void archive(Archive& archive) {
        auto& [at, to, along, own, poorest, measured, measuredAt, before, last, fresh, counted] = *this;
        archive(at, to, along, own, poorest, measured, measuredAt, before, last, fresh, counted);
    }
};

/// How VelocitySolver::descend() descends.
template <int Dim>
struct Descent {
    double tolerance = 1e-8;  // for the largest displacement of the last Newton step, in sizes
    int mostIterations = 300;
    /// Iterates with the factor at hand, of predict() or the last descent, as long as steps fall quickly: for
    /// a live drag. The result then depends on what was computed before, within the tolerance.
    bool reusesFactor = false;
    /// Puts points that slide on surfaces back on them, and calls setDirections(); empty: none do.
    std::function<void(Points<Dim>& shape)> keep;
};

/// How a descent ended.
struct Descended {
    SolveOutcome outcome;
    int iterations = 0;  // of Newton's method
    bool isConverged = false;
    bool isStable = true;  // false: a saddle was met on the way
};

/// The velocity tolerance that keeps the solver's part of the error of an integration well below the
/// integration's own tolerance (both relative: to the largest velocity, to the size).
double velocityToleranceFor(double integrationTolerance);

/// The velocity field v̂ of least energy that takes the prescribed velocities of the constrained points
/// (docs/method.md, (13) and (14)): min vᵀ A v subject to the rows. Constraints are
/// eliminated exactly: v = Z y + v_p, and K y = −Zᵀ A v_p with K = Zᵀ A Z sparse, symmetric, positive
/// definite. All lengths are in the frame where the rest shape has size 1: the caller passes normalized
/// coordinates. Deterministic: the same input gives the same bits for any number of threads. One thread uses
/// it at a time.
template <int Dim>
class VelocitySolver {
  public:
    /// Mesh and material are valid (requireValid). threads = 0: all cores, where that pays.
    VelocitySolver(std::shared_ptr<const SimplicialMesh<Dim>> normalizedRest,
                   std::shared_ptr<const Material<Dim>> material, BackEndKind kind = BackEndKind::Automatic,
                   int threads = 0, SolverKind solver = SolverKind::Direct);
    /// The same with a back end of the caller's. Multigrid computes on the processor all the same, in this
    /// process if `multigrid` is empty.
    VelocitySolver(std::shared_ptr<const SimplicialMesh<Dim>> normalizedRest,
                   std::shared_ptr<const Material<Dim>> material, const BackEndFactory<Dim>& backEnd,
                   int threads, SolverKind solver = SolverKind::Direct,
                   const IterativeSolverFactory<Dim>& multigrid = {});
    ~VelocitySolver();
    VelocitySolver(VelocitySolver&&) noexcept;
    VelocitySolver& operator=(VelocitySolver&&) noexcept;

    /// Once per set (nothing if the rows are those set already). Dependent rows are left
    /// out: see dependentRows(). Throws InputError for a vertex out of range, a weight that is not finite, a
    /// row of no weight. What a row says of a vertex comes before what `sliders` say. The mesh's welds hold
    /// beside any set: Σ weight v = 0.
    void setConstraints(std::vector<ConstraintRow> rows, Sliders sliders = {});
    /// Sets the directions of guided sliders for the next solves, one column of length 1 per slider; columns
    /// of other sliders do not count. The analysis and the factor stay.
    void setDirections(const Points<Dim>& directions);
    /// The symbolic analysis for these constraints, which the first solve makes otherwise. False if it was
    /// stopped (setStop()).
    bool analyze();

    /// v̂ at a shape; `prescribed` has one column per row, and after them one per slider, or none for sliders
    /// that are held still. `velocity` is defined only if done. Vertices without cells that no row names stay
    /// put. Parts with too few constrained points (2D: fewer than two distinct ones, 3D: than three that are
    /// not on a line) take the velocity of least ∫|v|² among those of least energy; without any constraint
    /// that is 0.
    ///
    /// With a velocity tolerance the factor of an earlier shape serves again while that is the least work,
    /// and a `guess` (of any kind: only its unconstrained part counts, see VelocityHistory) saves iterations;
    /// then the result depends, within the tolerance, on the solves since the last factorization.
    SolveOutcome solve(const Points<Dim>& shape, const Points<Dim>& prescribed, Points<Dim>& velocity,
                       const std::optional<Points<Dim>>& guess = std::nullopt);
    /// The same at the shape of stages(), wherever the back end keeps it.
    SolveOutcome solveAtStage(const Points<Dim>& prescribed, Points<Dim>& velocity,
                              const std::optional<Points<Dim>>& guess = std::nullopt);
    StageVectors<Dim>& stages();

    /// The rate at which the shape is drawn back to its rest (docs/method.md, section 8): from now on v̂
    /// minimizes E(v) + rate ⟨∇W(x), v⟩. 0, the default: the paper's field.
    void setMemoryRate(double rate);
    /// W of a shape; infinite if a cell is inverted.
    double restEnergy(const Points<Dim>& shape) const;
    /// ‖∇W‖ of a shape, without what the constraints hold: 0 where it has settled.
    double restForce(const Points<Dim>& shape) const;

    /// Newton's method for the minimum of W under the constraints, for direct solvers only. `predict`
    /// computes the first Newton step from a shape that displaces the constrained points by `prescribed` (as
    /// for solve()): near a minimum the derivative of the minimizer with respect to the constraints.
    /// `descend` moves a shape that satisfies the constraints to a minimum; after an outcome that is not done
    /// the shape is the best one so far.
    SolveOutcome predict(const Points<Dim>& shape, const Points<Dim>& prescribed, Points<Dim>& step);
    Descended descend(Points<Dim>& shape, const Descent<Dim>& descent = {});
    /// Adds weight · (x − x₀)ᵀ A (x − x₀) to W for both, A at the shape x₀ = `origin`; with weight 0 nothing,
    /// as at first. Returns the cell that is inverted there, or −1.
    int setProximal(double weight, const Points<Dim>& origin);

    /// The error of v̂ that is allowed, relative to its largest nodal velocity. 0 (the default): every solve
    /// factorizes, by CHOLMOD. So does every one, by a factor of our own in double precision, with less than
    /// 1e-8, and with materials on the way to EQUIA, whose factors do not last. Multigrid iterates in any
    /// case, to 1e-9 at best.
    void setVelocityTolerance(double tolerance);
    /// Whether a factor may serve for several solves: by the tolerance and the material.
    bool reuses() const;
    /// For an even pace rather than the least work in all: a factor that costs more than so many seconds of a
    /// nominal machine (SolverCost) serves as long as iterations with it are not much dearer than the pace.
    void setLongestPause(double seconds);
    /// A wish to stop ends a solve that goes on: between the iterations, and within an analysis or a
    /// factorization. What was remembered before it leads to the same bits again.
    void setStop(std::stop_token stop);
    /// From now on tells how far the work on a field is; factors only if they take long.
    void setProgress(FieldProgress progress);
    /// To be taken between solves, and given back before the solves that are to go on from it, after their
    /// constraints were set. A factor that is no longer there is made again when it is needed.
    FactorMemory<Dim> remember() const;
    void recall(const FactorMemory<Dim>& memory);
    /// The next solve factorizes, as the first one did: so that what follows has the same bits whatever was
    /// solved before.
    void forget() { recall({}); }

    /// E(v̂) of the last solve, in normalized units; computed when asked for.
    double energy() const;
    const SolverStatistics& statistics() const;
    /// Direct or Multigrid.
    SolverKind solver() const;
    /// "cpu" or "opencl", and the device's name.
    std::string backEndName() const;
    std::string deviceName() const;
    CopiedBytes copied() const;

    /// Turns fields along with the surroundings of every vertex, from one shape to another.
    void turn(const Points<Dim>& from, const Points<Dim>& to, std::vector<Points<Dim>>& fields);

    /// Moves the shape by the least-norm correction that puts the constrained points on `targets` (one column
    /// per row, and maybe after them one per slider, which without one stays where it is in its held
    /// directions), to rounding: rows of one vertex set it exactly.
    void project(Points<Dim>& shape, const Points<Dim>& targets) const;

    /// For tests: K of the last factorization, dense, and the unknown vertices in the order of its blocks.
    Eigen::MatrixXd reducedMatrix() const;
    const std::vector<int>& unknownVertices() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace wend
