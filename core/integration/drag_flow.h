#pragma once

#include <memory>

#include "core/base/message.h"
#include "core/integration/orientation.h"
#include "core/mesh/used_vertices.h"
#include "core/motion/constraints.h"
#include "core/solver/velocity_history.h"
#include "core/solver/velocity_solver.h"

namespace wend {

/// Computes the flow of a drag, a preview at the rate of a display. It usually solves one velocity field per
/// target, by the midpoint rule with the midpoint predicted from earlier fields. Since v̂ is linear in the
/// handles' velocities, the combination of earlier fields that moves the handles as wanted is off by no more
/// than the field's change in a step, and the step is of second order. Factors are reused. An elastic shape
/// follows its minimum by Newton's method, to 1e-4 of its size. Coordinates are the domain's.
template <int Dim>
class DragFlow {
  public:
    /// `handles` hold the shape; their motions are ignored. Analyzes and factorizes at once, so that a drag
    /// starts without delay. Throws InputError as Deformer does.
    DragFlow(std::shared_ptr<const SimplicialMesh<Dim>> rest, std::shared_ptr<const Material<Dim>> material,
             const std::vector<Handle<Dim>>& handles, const BackEndFactory<Dim>& backEnd, int threads = 0);

    /// Continues from a pose (Dim × n).
    void begin(const Points<Dim>& pose);

    /// The result of lead().
    struct Led {
        double done = 1;  // part of the motion that was possible
        Message problem;  // why it ended early: one line
    };
    /// The simultaneous displacement of another handle (by index), along straight lines.
    struct Alongside {
        int handle;
        AffineMap<Dim> map;
    };
    /// Moves some handles (by index) through a whole motion in one step of a few percent of the size; its
    /// interval is ignored. The others move as given, or hold still. If cells would be inverted, moves as far
    /// as possible.
    Led lead(const std::vector<int>& handles, const Motion<Dim>& motion,
             const std::vector<Alongside>& alongside = {});

    /// Returns the current pose (Dim × n) in the domain's coordinates.
    const Points<Dim>& pose() const { return m_pose; }
    /// Returns the largest distance of a constrained point from where it should be.
    double constraintError() const { return m_constraintError; }
    int evaluations() const { return m_evaluations; }
    const SolverStatistics& statistics() const { return m_solver.statistics(); }

  private:
    using Targets = Points<Dim>;  // one column per constrained point
    Targets moved(const Targets& start, const std::vector<int>& handles, const AffineMap<Dim>& map) const;
    double firstPart(const Targets& displacement) const;
    bool isElastic() const;
    bool step(const Targets& targets);
    bool track(const Targets& targets);
    bool relax(Points<Dim>& shape, const Targets& targets, int mostIterations);
    bool settle();
    bool solve(const Points<Dim>& shape, const Targets& displacement, Points<Dim>& field);
    bool moves(const Points<Dim>& field, const Targets& displacement) const;
    void prepare();
    void guide(const Points<Dim>& shape);
    void project(Points<Dim>& shape, const Targets& targets);
    void publish();
    Message describe(const SolveOutcome& failure, const std::vector<int>& handles) const;

    Normalization<Dim> m_units;
    std::shared_ptr<const SimplicialMesh<Dim>> m_domainRest, m_rest;
    std::vector<Twin> m_twins;
    Orientation<Dim> m_orientation;
    Constraints<Dim> m_constraints;
    VelocitySolver<Dim> m_solver;
    VelocityHistory<Dim> m_history;
    double m_memory;  // ρ; infinite: elastic
    Points<Dim> m_shape, m_pose;
    Targets m_targets, m_directions;
    Eigen::Index m_sliders = 0;
    std::vector<int> m_ids, m_guided;  // all points, and those that slide on surfaces and are not held
    SolveOutcome m_failure;
    bool m_isSettled = false;  // an elastic shape is at its minimum
    double m_constraintError = 0;
    int m_evaluations = 0;
};

}  // namespace wend
