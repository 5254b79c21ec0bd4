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

/// Says how a solve ended. A numerical outcome is a value, never an exception.
struct SolveOutcome {
    /// Stopped: the token of setStop() ended it. NotConverged: the iterations did not
    /// reach the tolerance.
    enum class Kind { Done, CellInverted, NotPositiveDefinite, NotFinite, NotConverged, Stopped };
    Kind kind = Kind::Done;
    int cell = -1;  // CellInverted: the first cell that is flat or turned over

    bool done() const { return kind == Kind::Done; }
};

/// The times (in seconds), counts and memory of the solves so far.
struct SolverStatistics {
    double analyze = 0, assemble = 0, factor = 0, solve = 0;  // seconds
    int analyses = 0, factorizations = 0, iterations = 0;     // iterations: pairs of triangular solves
    double needed = 0;                                        // bytes of the largest factor, or of multigrid
};

/// Holds what the next solves depend on besides their own arguments: the shape at which their first factor
/// was made, and the counts by which it is kept. With it a solver continues to the same bits as the one that
/// it was taken from. It is cheap to copy.
template <int Dim>
struct FactorMemory {
    Nodal<Dim> shape;       // null: the next solve factorizes
    Nodal<Dim> turned;      // to which it was turned last, if it was
    Nodal<Dim> directions;  // of guided sliders; null: there are none
    FactorKind kind = FactorKind::Single, best = FactorKind::Single;  // best: that does not fail here
    // The measured contractions of an iteration, if there are any: with a factor that is `contractionLag`
    // away from its shape, and with one in single precision at its own shape.
    std::optional<double> contraction;
    double contractionLag = 0;
    // The distances, as greatest differences of a coordinate, of the factor's shape from the one at which it
    // was made ahead, and of the last shape that was solved for from the factor's.
    double ahead = 0, lag = 0;
    std::optional<double> freshContraction;
    RefactorPolicy::Counts counts;

    template <class Archive>
    void archive(Archive& archive) {
        auto& [at, to, along, own, poorest, measured, measuredAt, before, last, fresh, counted] = *this;
        archive(at, to, along, own, poorest, measured, measuredAt, before, last, fresh, counted);
    }
};

/// The options of VelocitySolver::descend().
template <int Dim>
struct Descent {
    double tolerance = 1e-8;  // for the largest displacement of the last Newton step, in sizes
    int mostIterations = 300;
    /// Iterates with the current factor, of predict() or the last descent, as long as steps decrease quickly:
    /// for a live drag. The result then depends, within the tolerance, on what was computed before.
    bool reusesFactor = false;
    /// Puts points that slide on surfaces back on them, and calls setDirections(); empty if none do.
    std::function<void(Points<Dim>& shape)> keep;
};

/// How a descent ended.
struct Descended {
    SolveOutcome outcome;
    int iterations = 0;  // of Newton's method
    bool isConverged = false;
    bool isStable = true;  // false: it passed a saddle
};

/// Returns the velocity tolerance that keeps the solver's part of the error of an integration well below the
/// integration's own tolerance (both relative: to the largest velocity, to the size).
double velocityToleranceFor(double integrationTolerance);

/// Computes the velocity field v̂ of least energy that takes the prescribed velocities of the constrained
/// points (docs/method.md, (13) and (14)): min vᵀ A v subject to the rows. Constraints are eliminated
/// exactly: v = Z y + v_p, and K y = −Zᵀ A v_p with K = Zᵀ A Z sparse, symmetric, positive definite. All
/// lengths are in the frame where the rest shape has size 1: the caller passes normalized coordinates. It is
/// deterministic: the same input gives the same bits for any number of threads. One thread uses it at a time.
template <int Dim>
class VelocitySolver {
  public:
    /// Mesh and material must be valid (requireValid). With threads = 0 it uses all cores, where that pays.
    VelocitySolver(std::shared_ptr<const SimplicialMesh<Dim>> normalizedRest,
                   std::shared_ptr<const Material<Dim>> material, BackEndKind kind = BackEndKind::Automatic,
                   int threads = 0, SolverKind solver = SolverKind::Direct);
    /// Does the same with a back end of the caller's. Multigrid computes on the processor all the same, in
    /// this process if `multigrid` is empty.
    VelocitySolver(std::shared_ptr<const SimplicialMesh<Dim>> normalizedRest,
                   std::shared_ptr<const Material<Dim>> material, const BackEndFactory<Dim>& backEnd,
                   int threads, SolverKind solver = SolverKind::Direct,
                   const IterativeSolverFactory<Dim>& multigrid = {});
    ~VelocitySolver();
    VelocitySolver(VelocitySolver&&) noexcept;
    VelocitySolver& operator=(VelocitySolver&&) noexcept;

    /// Sets the constraints; does nothing if these rows are set already. Dependent rows are left out: see
    /// dependentRows(). A row for a vertex takes precedence over its sliders. The mesh's welds hold besides
    /// any set: Σ weight v = 0. Throws InputError for a vertex out of range, a weight that is not finite, and
    /// a row of no weight.
    void setConstraints(std::vector<ConstraintRow> rows, Sliders sliders = {});
    /// Sets the directions of guided sliders for the next solves, one column of length 1 per slider; columns
    /// of other sliders do not count. The analysis and the factor stay.
    void setDirections(const Points<Dim>& directions);
    /// Does the symbolic analysis for these constraints, which the first solve does otherwise. Returns false
    /// if it was stopped (setStop()).
    bool analyze();

    /// Computes v̂ at a shape (Dim × n). `prescribed` has one column per row, and after them one per slider,
    /// or none for sliders that are held still. `velocity` is defined only if done. Vertices without cells
    /// that no row names stay put. Parts with too few constrained points (2D: fewer than two distinct ones,
    /// 3D: than three that are not on a line) take the velocity of least ∫|v|² among those of least energy;
    /// without any constraint that is 0.
    ///
    /// With a velocity tolerance the factor of an earlier shape serves again while that is the least work,
    /// and a `guess` (of any kind: only its unconstrained part counts, see VelocityHistory) saves iterations;
    /// then the result depends, within the tolerance, on the solves since the last factorization.
    SolveOutcome solve(const Points<Dim>& shape, const Points<Dim>& prescribed, Points<Dim>& velocity,
                       const std::optional<Points<Dim>>& guess = std::nullopt);
    /// Does the same at the shape of stages(), wherever the back end keeps it.
    SolveOutcome solveAtStage(const Points<Dim>& prescribed, Points<Dim>& velocity,
                              const std::optional<Points<Dim>>& guess = std::nullopt);
    StageVectors<Dim>& stages();

    /// Sets the rate at which the shape is drawn back to its rest (docs/method.md, section 8): from now on v̂
    /// minimizes E(v) + rate ⟨∇W(x), v⟩. With 0, the default, it is the paper's field.
    void setMemoryRate(double rate);
    /// Returns W of a shape; infinite if a cell is inverted.
    double restEnergy(const Points<Dim>& shape) const;
    /// Returns ‖∇W‖ of a shape, without the part that the constraints hold: 0 where it has settled.
    double restForce(const Points<Dim>& shape) const;

    /// Minimize W under the constraints by Newton's method, for direct solvers only. `predict` computes the
    /// first Newton step from a shape that displaces the constrained points by `prescribed` (as for solve()):
    /// near a minimum this is the derivative of the minimizer with respect to the constraints. Components
    /// whose constraints leave a rigid motion free are carried by the mean displacement of theirs. `descend`
    /// moves a shape that satisfies the constraints to a minimum; after an outcome that is not done the shape
    /// is the best one so far.
    SolveOutcome predict(const Points<Dim>& shape, const Points<Dim>& prescribed, Points<Dim>& step);
    Descended descend(Points<Dim>& shape, const Descent<Dim>& descent = {});
    /// Adds weight · (x − x₀)ᵀ A (x − x₀) to W for both functions, with A at the shape x₀ = `origin`; weight
    /// 0, the initial value, adds nothing. Returns the cell that is inverted at x₀, or −1.
    int setProximal(double weight, const Points<Dim>& origin);

    /// Sets the error of v̂ that is allowed, relative to its largest nodal velocity. With 0 (the default),
    /// every solve factorizes by CHOLMOD. Below 1e-8, and for materials near EQUIA, whose factors do not
    /// last, every solve factorizes in double precision by Wend's own factor. Multigrid iterates in any case,
    /// to 1e-9 at best.
    void setVelocityTolerance(double tolerance);
    /// Returns whether a factor may serve for several solves, by the tolerance and the material.
    bool reuses() const;
    /// Prefers an even pace to the least work in all: a factor that costs more than so many seconds of a
    /// nominal machine (SolverCost) serves as long as iterations with it are not much more expensive than the
    /// pace.
    void setLongestPause(double seconds);
    /// Sets the token that stops a running solve: between its iterations, and within an analysis or a
    /// factorization. The memory that was taken before the solve leads to the same bits again.
    void setStop(std::stop_token stop);
    /// Sets the receiver of progress on a field; factors report only if they take long.
    void setProgress(FieldProgress progress);
    /// Return and restore the memory. It is taken between solves, and restored before the solves that are to
    /// continue from it, after their constraints were set. A factor that is no longer available is made again
    /// when it is needed.
    FactorMemory<Dim> remember() const;
    void recall(const FactorMemory<Dim>& memory);
    /// Makes the next solve factorize as the first one did, so that the following solves have the same bits
    /// whatever was solved before.
    void forget() { recall({}); }

    /// Returns E(v̂) of the last solve, in normalized units; it is computed on request.
    double energy() const;
    const SolverStatistics& statistics() const;
    /// Returns Direct or Multigrid.
    SolverKind solver() const;
    /// Return "cpu" or "opencl", and the name of the device.
    std::string backEndName() const;
    std::string deviceName() const;
    CopiedBytes copied() const;

    /// Turns fields along with the surroundings of every vertex, from one shape to another.
    void turn(const Points<Dim>& from, const Points<Dim>& to, std::vector<Points<Dim>>& fields);

    /// Moves the shape by the least-norm correction that puts the constrained points on `targets`, to
    /// rounding; rows of one vertex set it exactly. `targets` has one column per row and may have one per
    /// slider behind them; without one a slider stays where it is in its held directions.
    void project(Points<Dim>& shape, const Points<Dim>& targets) const;

    /// Return, for tests, K of the last factorization as a dense matrix, and the unknown vertices in the
    /// order of its blocks.
    Eigen::MatrixXd reducedMatrix() const;
    const std::vector<int>& unknownVertices() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace wend
