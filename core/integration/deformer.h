#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/assembly/back_end.h"
#include "core/base/message.h"
#include "core/energy/material.h"
#include "core/integration/integration_options.h"
#include "core/integration/step_progress.h"
#include "core/integration/step_record.h"
#include "core/motion/constraints.h"
#include "core/solver/velocity_history.h"
#include "core/solver/velocity_solver.h"

namespace wend {

/// Says how an advance ended. A numerical outcome is a value, never an exception.
enum class Outcome { Done, Cancelled, CellInverted, SolverFailed, StepTooSmall };
/// The result of advance(). The state of the deformer is that at `time`.
struct AdvanceResult {
    Outcome outcome = Outcome::Done;
    double time = 0;     // the last good time
    int cell = -1;       // CellInverted: the cell that would fold over
    Message message;     // one line with what happened, when and where; empty when done
    Message brief = {};  // the same without the time and the cell, and with a rough place
};

/// Records that an elastic shape jumped to another minimum, because the one before had ceased to exist.
struct Snap {
    double time = 0;
    std::array<double, 3> place{};  // that moved the farthest, in the domain's coordinates

    /// Passes all members to an archive, which stores or restores them.
    template <class Archive>
    void archive(Archive& archive) {
        auto& [at, where] = *this;
        archive(at, where[0], where[1], where[2]);
    }
};

/// Counts and measures the work of a run so far. Times are in seconds of the wall clock, lengths relative to
/// the size of the rest shape (ShapeSize), and energies in the frame where that size is 1. The counts do not
/// depend on the number of threads; the times do.
struct Statistics {
    int steps = 0, rejected = 0, evaluations = 0, factorizations = 0, solverIterations = 0;
    double analyze = 0, assemble = 0, factor = 0, solve = 0, integrate = 0;  // seconds
    double constraintError =
        0;              // largest distance of a constrained point from its trajectory, relative to the size
    double energy = 0;  // E(v̂) at the last evaluation, in normalized units
    /// Sum of the method's error estimates of accepted steps, relative to the size; 0 with prescribed steps.
    /// Later steps may amplify or damp errors, so this is an order of magnitude.
    double errorEstimate = 0;
    double needed = 0;        // bytes of the largest factor
    std::vector<Snap> snaps;  // of an elastic shape, in the order of time
    CopiedBytes copied;       // to and from a device, since the deformer was made

    template <class Archive>
    void archive(Archive& archive) {
        auto& [taken, refused, solves, factors, rounds, analyzing, assembling, factoring, solving, inAll, off,
               value, sum, bytes, snapped, moved] = *this;
        archive(taken, refused, solves, factors, rounds, analyzing, assembling, factoring, solving, inAll,
                off, value, sum, bytes, snapped);
    }
};

/// The shape at a time, with everything needed to continue to the same bits.
template <int Dim>
struct State {
    double time = 0;
    Points<Dim> points;  // in the domain's own coordinates

    // The following members are set in states between steps only, not in frames from dense output; without
    // them a run continues, but not to the same bits.
    Points<Dim> normalized;         // the same shape in the frame of the computation
    Pace<Dim> pace;                 // of the method
    VelocityHistory<Dim> history;   // from which the next field is guessed
    FactorMemory<Dim> factor;       // with which it is solved for
    std::vector<Vec<Dim>> anchors;  // per constrained point: see Constraints; normalized
    std::shared_ptr<const std::vector<ConstrainedPoint>>
        constrained;  // the points that the anchors belong to
};

/// Integrates dx/dt = v̂(x, t): at each time the velocity field of least energy that takes the handles'
/// velocities. Rest mesh, material and handles are in the domain's own coordinates; normalization is
/// internal. One thread uses it at a time.
template <int Dim>
class Deformer {
  public:
    /// Throws InputError for an invalid mesh or material, a handle outside the shape, and contradictory
    /// handles, of which it names both.
    Deformer(std::shared_ptr<const SimplicialMesh<Dim>> rest, std::shared_ptr<const Material<Dim>> material,
             std::vector<Handle<Dim>> handles, IntegrationOptions options = {},
             BackEndKind backEnd = BackEndKind::Automatic);
    /// Does the same with a back end of the caller's, such as OpenCL's, and an iterative solver: see
    /// VelocitySolver.
    Deformer(std::shared_ptr<const SimplicialMesh<Dim>> rest, std::shared_ptr<const Material<Dim>> material,
             std::vector<Handle<Dim>> handles, IntegrationOptions options, const BackEndFactory<Dim>& backEnd,
             const IterativeSolverFactory<Dim>& multigrid = {});
    ~Deformer();
    Deformer(Deformer&&) noexcept;
    Deformer& operator=(Deformer&&) noexcept;

    /// Returns the current shape and what is needed to continue from it.
    const State<Dim>& state() const;
    /// Continues from a state of this deformer, or of one with the same rest mesh, material and earlier
    /// handles. Throws InputError if the number of vertices differs.
    void restore(const State<Dim>& state);
    /// Sets other motions from state().time on (earlier ones are ignored), with the same checks as the
    /// constructor.
    void setHandles(std::vector<Handle<Dim>> handles);
    /// Analyzes the system that acts from state().time on, which advance() otherwise does. For a large shape
    /// this is 0.3 s of uninterruptible work.
    void prepare();

    /// Integrates to `time`, where the last step is cut; without a moving handle the shape stays. `frames`
    /// (increasing, in [state().time, time]) are times at which `onFrame` gets the pose by dense output,
    /// without changing the steps. `progress` gets the time after every accepted step. If it ends early,
    /// state() is the last valid one. Throws NotEnoughMemory before it makes a factor that does not fit into
    /// memory.
    struct Watch {
        std::vector<double> frames;
        /// The first step that reaches this time is the last one; it is not cut there.
        double enough = std::numeric_limits<double>::infinity();
        std::function<void(const State<Dim>&)> onFrame;
        std::function<void(double)> progress;
        std::stop_token stop;
        /// Gets the progress within a step while its fields are computed, at most once per `withinEvery` and
        /// from any thread.
        StepProgress::Sink within;
        std::chrono::milliseconds withinEvery{100};
        /// Gets every step that was computed, once state() is the shape at its end.
        std::function<void(const StepRecord<Dim>&)> onStep;
        /// Supplies steps that are taken from here instead of being computed, as long as there are any. They
        /// begin at the current state.
        StepSource<Dim>* known = nullptr;
    };
    /// Advances as is said above. A `time` that is not after state().time takes no step, and emits the frames
    /// that are due.
    AdvanceResult advance(double time, const Watch& watch = {});

    /// Returns v̂ at the current state, one column per vertex, in the domain's units per unit of time.
    /// Between two motions the one that begins counts; if nothing moves from here on, the one that ends.
    /// There are no columns if the solver fails or is stopped. It is solved for exactly, whatever the
    /// tolerance, and leaves the state and the bits of a continued run as they are.
    Points<Dim> velocity(const std::stop_token& stop = {});
    /// Returns why the last advance() ended early, or why velocity() has no columns.
    AdvanceResult failure() const;
    /// Return W of the current state, the energy of its map from rest, and its distance from equilibrium,
    /// ‖∇W‖ without the part that the constraints hold (docs/method.md, section 8), both in normalized units.
    double restEnergy() const;
    double restForce();
    /// Returns the counts and times of the work so far.
    const Statistics& statistics() const;
    /// Returns Direct or Multigrid.
    SolverKind solver() const;
    /// Return "cpu" or "opencl", and the name of the device.
    std::string backEndName() const;
    std::string deviceName() const;

  private:
    struct Integrator;
    std::unique_ptr<Integrator> m_integrator;
};

}  // namespace wend
