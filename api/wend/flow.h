#pragma once

/// @file
/// The deformation of a mesh by handles, as the integral of velocity fields of least energy.

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "wend/handles.h"

namespace wend {

/// Selects what a shape keeps as it moves: area or volume, lengths, rigidity, or angles.
enum class Keep { Measure, Length, Rigidity, Angles };

/// φ in radians of a named energy in 2 or 3 dimensions: arctan 2⁻⁹, arctan ½, π/2, and φ_CONF(d) =
/// π − arctan(d/4); docs/method.md (5).
/// @throws InvalidInput for another dimension.
WEND_API double phiOf(Keep keep, int dimension);

/// How jumps of the velocity's Jacobian over facets are priced: by a length that does not depend on the mesh,
/// docs/method.md (10); as in the paper, (12); or not at all.
enum class JumpPrice { Length, Paper, None };

/// The material of a shape.
template <int Dim>
struct FlowMaterial {
    double phi = phiOf(Keep::Length, Dim);  ///< In ]0, φ_CONF(Dim)] radians, of all cells.
    std::vector<double> cellPhi = {};       ///< One per cell instead, or empty.
    /// One symmetric positive definite Dim × Dim matrix per cell, by rows, or empty for the identity: it
    /// makes directions stiff, docs/method.md (6).
    std::vector<std::array<double, Dim* Dim>> anisotropy = {};
    JumpPrice jumps = JumpPrice::Length;  ///< Smoothness of the velocity over facets.
    double smoothing = 1.0 / 75;          ///< JumpPrice::Length: s, relative to the size of the rest shape.
    double lambda = 0.1;                  ///< JumpPrice::Paper: λ.
    /// ρ ≥ 0, how strongly the shape is drawn back to rest, docs/method.md (22). With infinity it is elastic,
    /// (24): the shape depends on where the handles are and not on their paths.
    double memory = 0;
};

/// The method of integration: Adams of variable order and Dormand–Prince 5(4) choose their steps by the
/// tolerance, the others need their number.
enum class Stepping { Adams, DormandPrince, RungeKutta4, Midpoint };

/// How a flow is integrated.
struct FlowOptions {
    Stepping method = Stepping::Adams;  ///< Of the steps in time.
    double tolerance = 1e-4;  ///< Error per step that is allowed, relative to the size; 1e-12 to 0.1.
    int steps = 0;            ///< If greater than 0, so many equal steps over [0, end].
    double end = 1;           ///< With `steps`, the time that they are spread over.
    int threads = 0;          ///< 0: all cores. Results have the same bits for any number.
};

/// How a run ended. A numerical outcome is a value; exceptions are for input.
enum class Ending {
    Done,          ///< The time was reached.
    Cancelled,     ///< RunControl::stop was requested.
    CellInverted,  ///< A cell would turn over: RunResult::cell.
    SolverFailed,  ///< A velocity field could not be solved for.
    StepTooSmall   ///< Steps became too small.
};

/// The result of run(). Unless done, the flow is at the last good shape.
struct RunResult {
    Ending ending = Ending::Done;  ///< How it ended.
    double time = 0;               ///< Of the shape that the flow is at.
    int cell = -1;                 ///< The cell that would turn over; −1: none.
    std::string message = {};      ///< One line with what happened, when and where; empty when done.

    /// Returns whether the time was reached.
    bool done() const { return ending == Ending::Done; }
};

/// What a run calls back. Both are called and read in the thread that called run().
struct RunControl {
    std::function<void(double time)> progress = {};  ///< After every accepted step. Must not throw.
    std::stop_token stop = {};                       ///< Ends the run at the next opportunity.
};

/// Distances of a shape from rest, docs/method.md (26)–(28): 0 is best. One value per cell, and the means
/// weighted with the cells' measures at rest. All are dimensionless.
struct FlowDistortion {
    std::vector<double> angle = {};   ///< Σ_{j<k} (σ_j/σ_k + σ_k/σ_j − 2) per cell.
    std::vector<double> volume = {};  ///< Π σ + 1/Π σ − 2 per cell.
    std::vector<double> metric = {};  ///< Σ_j (σ_j − 1)² − Σ_{j<k} (σ_j − σ_k)² / (Dim + 2) per cell.
    std::vector<double> ratio = {};  ///< det F per cell: its change of area or volume.
    double totalAngle = 0;           ///< Mean of `angle`.
    double totalVolume = 0;          ///< Mean of `volume`.
    double totalMetric = 0;          ///< Mean of `metric`.
    int inverted = 0;                ///< Number of cells with det F ≤ 0.
};

/// Counts of all runs of a flow, and the wall time in seconds that they took.
struct FlowStatistics {
    int steps = 0;             ///< Accepted steps.
    int rejected = 0;          ///< Steps that were made again, shorter.
    int evaluations = 0;       ///< Velocity fields that were solved for.
    int factorizations = 0;    ///< Numerical factorizations.
    int solverIterations = 0;  ///< Iterations with factors of earlier shapes.
    double analyze = 0;        ///< Seconds of symbolic work, which depends on the mesh and on what is held.
    double assemble = 0;       ///< Seconds of assembling matrices.
    double factor = 0;         ///< Seconds of numerical factorization.
    double solve = 0;          ///< Seconds of solving.
    /// Times at which an elastic shape went on from another minimum, since the one before had ended.
    std::vector<double> snaps = {};
    /// Largest distance of a constrained point from its trajectory in the last run, relative to the size.
    double constraintError = 0;
};

/// Not for users of the library.
template <int Dim>
struct FlowMaker;

/// A mesh that handles bend. At each time the velocity field
///
///     v̂ = argmin_v E(v)   subject to   W v = u(t)
///
/// of least generalized metric energy that takes the handles' velocities is solved for, and the shape follows
/// it, dx/dt = v̂(x, t); docs/method.md (13) and (16). Constrained points are on their paths to rounding, and
/// no cell turns over.
///
/// Mesh, assembly plan and symbolic factorization are kept from one run to the next: reset() and
/// setMovement() change no more than the motion, so that a run in a loop costs its steps only. The result of
/// a run from rest does not depend on the runs before it, to the last bit.
///
/// **Threads.** A flow is used by one thread at a time. Flows share nothing: two of them may run in two
/// threads. A run may use FlowOptions::threads threads of its own; it is ended from another thread by
/// RunControl::stop.
///
/// **Errors.** Every function that can fail says how; none throws anything else, but std::bad_alloc and
/// std::system_error of the standard library.
template <int Dim>
class WEND_API Flow {
  public:
    /// @param points the rest shape, n of them, in any unit of length
    /// @param cells  m triangles or tetrahedra, all of one orientation
    /// @param material what the shape is made of
    /// @param options how it is integrated
    /// @throws InvalidInput for a mesh that is no partition (a repeated or missing vertex, a flat or
    /// duplicate cell, cells of both orientations, a facet of three cells, no cell), and for a material or
    /// options out of range.
    Flow(std::span<const Coordinates<Dim>> points, std::span<const CellVertices<Dim>> cells,
         const FlowMaterial<Dim>& material = {}, const FlowOptions& options = {});
    /// Does the same for a mesh.
    explicit Flow(const Mesh<Dim>& mesh, const FlowMaterial<Dim>& material = {},
                  const FlowOptions& options = {});
    ~Flow();
    /// A flow that was moved from may only be assigned to or destroyed.
    Flow(Flow&&) noexcept;
    /// See the constructor.
    Flow& operator=(Flow&&) noexcept;

    /// Adds a handle that holds still, and returns its number, from 0. Errors of handles, such as a place
    /// outside the shape or two handles that contradict each other, are thrown by the next run(), velocity()
    /// or prepare().
    int hold(const Place<Dim>& place);
    /// Adds a handle that moves, and returns its number.
    int move(const Place<Dim>& place, const Movement<Dim>& movement);
    /// Gives a handle another movement, from time() on: what of it is earlier does not count.
    /// @throws InvalidInput if there is no such handle.
    void setMovement(int handle, const Movement<Dim>& movement);
    /// Removes all handles.
    void clear();
    /// Returns the number of handles.
    int handleCount() const;

    /// Brings the shape back to rest, and time to 0. Handles stay.
    void reset();
    /// Analyzes the linear system now, which the first run() does otherwise.
    /// @throws InvalidInput for the handles, see hold(); InsufficientMemory.
    void prepare();
    /// Integrates from time() to the end of the last movement, or to 1 if nothing moves.
    /// @throws InvalidInput for the handles, see hold(); InsufficientMemory before a factor is made that the
    /// machine has not the memory for.
    RunResult run(const RunControl& control = {});
    /// Integrates from time() to `until`. Without a moving handle the shape stays.
    /// @throws as run(); InvalidInput for a time before time(), or one that is not finite.
    RunResult run(double until, const RunControl& control = {});

    /// Returns the time of the shape, from 0.
    double time() const;
    /// Returns the n points of the shape, in the order and unit of the constructor's. They are valid until
    /// the flow changes.
    std::span<const Coordinates<Dim>> points() const;
    /// Returns the n points of the shape at rest.
    std::span<const Coordinates<Dim>> restPoints() const;
    /// Returns the cells.
    std::span<const CellVertices<Dim>> cells() const;
    /// Returns the velocity of every vertex at time(), in units of length per unit of time. Between two
    /// movements the one that begins counts. Empty if it cannot be solved for.
    /// @throws as run().
    std::vector<Coordinates<Dim>> velocity();

    /// How far the shape is from rest.
    FlowDistortion distortion() const;
    /// Returns the least det F of all cells, their change of area or volume, which is greater than 0.
    double minDet() const;
    /// Returns the cell of the largest metric error, docs/method.md (28).
    int worst() const;
    /// W of the shape, the energy of its map from rest, docs/method.md (19), in the unit where the size is 1.
    double restEnergy() const;
    /// Counts and seconds of all runs so far.
    FlowStatistics statistics() const;

  private:
    friend struct FlowMaker<Dim>;
    struct Impl;
    explicit Flow(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

extern template class Flow<2>;
extern template class Flow<3>;

}  // namespace wend
