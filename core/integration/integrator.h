#pragma once

#include <optional>

#include "core/integration/deformer.h"
#include "core/integration/orientation.h"
#include "core/integration/settling.h"
#include "core/mesh/used_vertices.h"

namespace wend {

/// Integrates one deformation in the frame where the rest shape has size 1 (docs/method.md, section 6).
/// Time is cut at breakpoints: those of the constraints (intervals, jumps of velocities, active ranges) and
/// of relaxations. A step never crosses one, and the step control restarts at each, so that a run that starts
/// there takes the same steps. A step depends on the state alone: before each, the solver and the guesses are
/// restored from the state, so that a run continues to the same bits after a rejection, a cancellation, a
/// query, and in another deformer.
template <int Dim>
struct Deformer<Dim>::Integrator {
    using SolverFactory =
        std::function<VelocitySolver<Dim>(std::shared_ptr<const SimplicialMesh<Dim>>, SolverKind)>;
    Integrator(std::shared_ptr<const SimplicialMesh<Dim>> rest, std::shared_ptr<const Material<Dim>> material,
               const std::vector<Handle<Dim>>& handles, const IntegrationOptions& options,
               SolverFactory makeSolver);

    void setHandles(const std::vector<Handle<Dim>>& handles);
    void restore(const State<Dim>& state);
    /// Sets the constraints that act before or after the current time.
    void activate(Side side);
    AdvanceResult advance(double time, const Watch& watch);
    Points<Dim> velocity(const std::stop_token& stop);
    /// Returns why the last advance() or velocity() failed.
    AdvanceResult stopped() const;
    double restForce();

    State<Dim> state;
    Statistics statistics;
    VelocitySolver<Dim>& velocitySolver() { return *m_solver; }

  private:
    /// The failure of an attempted step.
    struct Failure {
        SolveOutcome outcome;
        double time = 0;
        bool cancelled = false;
        bool stepTooSmall = false;
    };

    // The shape and its constraints
    void adopt(std::shared_ptr<const Constraints<Dim>> constraints);
    Points<Dim> inDomain(const Points<Dim>& shape) const;
    int firstInverted(const Points<Dim>& shape) const;
    void startAnew();
    void recall();
    void remember();
    bool evaluate(double t, Side side, Points<Dim>& velocity);
    bool solveDirectly();
    double memoryRate(double t, Side side) const;
    void prescribe(double t, Side side, const Points<Dim>& shape);
    void project(double t, Points<Dim>& shape);

    // Relaxation
    enum class Relaxation { Explicit, Settling, Memory, Elastic };
    Relaxation relaxation(double t, Side side) const;
    double leastElasticStep() const;
    bool springs();
    Points<Dim> displacements(double t, const Points<Dim>& shape);
    bool failWith(const SolveOutcome& outcome, double t);
    bool predict(double to, Points<Dim>& shape);
    Descended descend(double t, Points<Dim>& shape, double tolerance, int mostIterations);
    bool proximalStep(const Points<Dim>& origin, double to, double pull, Points<Dim>& shape);
    bool settle(double from, double to, const Points<Dim>& start, Points<Dim>& result, double& error);
    bool relaxWithMemory(double from, double to, const Points<Dim>& start, Points<Dim>& result,
                         double& error);
    bool track(double from, double to, const Points<Dim>& start, Points<Dim>& result, double& error);
    bool relax(double from, double to, const Points<Dim>& start, Points<Dim>& result, double& error);
    void relaxFrame(double t, Points<Dim>& shape);
    bool leadElastic(double from, const Points<Dim>& start, double to, Points<Dim>& shape);
    bool elasticVelocity(double t, Side side, const Points<Dim>& shape, Points<Dim>& velocity);
    struct EndVelocities {
        Points<Dim> start, end;
    };
    std::optional<EndVelocities> endVelocities(double from, double to);
    void refineFrame(double from, double to, double t, const EndVelocities& v, Points<Dim>& shape);

    // Steps
    bool flows(double t, Side side) const;
    double nextBreakpoint(double t) const;
    double lastBreakpoint(double t) const;
    StepMethod<Dim>& method() const;
    double nextStop(double time) const;
    double startStep(double to) const;
    double proposedStep(double to) const;
    double stretch() const;
    double smallestStep() const;
    void failForSmallStep(double to);
    bool isTooStiff() const;
    Snap snapAt(int vertex) const;
    bool step(double stop);
    std::optional<double> attempt(const Nodal<Dim>& start, double to);
    void accept(double to, bool shortened, bool cut);
    void emitStanding(double to);
    void standStill(double to);
    void takeKnownStep();
    void repeat(const StepRecord<Dim>& step);
    void record(StepRecord<Dim> step);
    void arrive(double to);

    // Output of frames and failures.
    bool goesOn(double time);
    bool hasFramesBefore(double to) const;
    Nodal<Dim> endField(double from, double to);
    void emitFrames(double from, double to, const Nodal<Dim>& endField);
    void unfold(double t, Points<Dim>& shape, const Points<Dim>& end);
    void measureError(double t);
    int fastestPoint() const;
    int nearestPoint(const Vec<Dim>& place) const;
    void collectStatistics();

    IntegrationOptions m_options;
    Normalization<Dim> m_units;
    std::shared_ptr<const SimplicialMesh<Dim>> m_domainRest, m_rest;
    std::vector<Twin> m_twins;
    Orientation<Dim> m_orientation, m_domainOrientation;
    SolverFactory m_makeSolver;
    std::unique_ptr<VelocitySolver<Dim>> m_solver;
    std::shared_ptr<const Constraints<Dim>> m_constraints;
    Settling m_settling;
    double m_memory;                                              // ρ; infinite: elastic
    std::unique_ptr<StepMethod<Dim>> m_method, m_settlingMethod;  // the latter with multigrid
    std::unique_ptr<StepMethod<Dim>> m_implicit;
    // The order in the pace that says that memory makes explicit steps too short up to the next breakpoint.
    static constexpr int kImplicitOrder = -1;
    static constexpr double kStrongMemory = 40;
    VelocityHistory<Dim> m_history;

    Side m_activeSide = Side::Before;
    std::vector<int>
        m_ids;  // the active constrained points, as the solver has them: those that slide come last
    Eigen::Index m_sliders = 0;  // the number of those
    std::vector<int> m_guided;   // of these, those that slide on surfaces and that no other handle holds
    Points<Dim> m_targets, m_prescribed, m_directions;
    Points<Dim> m_next;   // the result of an attempt, projected
    Statistics m_before;  // of the run that known steps are from, and of the solver before this one
    Failure m_failure;
    std::optional<int> m_snapped;  // the vertex that moved the farthest where a minimum ended in this step
    bool m_springing = false;
    const Watch* m_watch = nullptr;
    StepProgress m_progress;
    size_t m_frame = 0;
};

}  // namespace wend
