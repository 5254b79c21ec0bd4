#pragma once

#include <memory>
#include <string>

#include "core/integration/orientation.h"
#include "core/mesh/used_vertices.h"
#include "core/motion/constraints.h"
#include "core/solver/velocity_history.h"
#include "core/solver/velocity_solver.h"

namespace wend {

/// The shape while handles are led by hand: a preview at the rate of a display. One velocity field per lead
/// as a rule, by the midpoint rule with the middle guessed from the fields before: v̂ is linear in the
/// handles' velocities, so the combination of them that moves the handles as wanted is off by no more than
/// the field changes in a step, and the step is of second order. Factors are reused. Coordinates are the
/// domain's.
template <int Dim>
class DragFlow {
  public:
    /// `handles` hold the shape; their motions do not matter. Analyzes and factorizes at once, so that a drag
    /// begins promptly. Throws InputError as Deformer does.
    DragFlow(std::shared_ptr<const SimplicialMesh<Dim>> rest, std::shared_ptr<const Material<Dim>> material,
             const std::vector<Handle<Dim>>& handles, const BackEndFactory<Dim>& backEnd, int threads = 0);

    /// Goes on from a pose.
    void begin(const Points<Dim>& pose);

    struct Led {
        double done = 1;      // part of the motion that was possible
        std::string problem;  // why it ended early: one line
    };
    /// Where the points of a handle (by index) go meanwhile, along straight lines.
    struct Alongside {
        int handle;
        AffineMap<Dim> map;
    };
    /// Leads some handles (by index) through a whole motion, whose window does not matter, in one step: a
    /// few percent of the size. The others go alongside, or hold still. Where cells would fold over, as far
    /// as is possible.
    Led lead(const std::vector<int>& handles, const Motion<Dim>& motion,
             const std::vector<Alongside>& alongside = {});

    const Points<Dim>& pose() const { return m_pose; }
    /// Largest distance of a constrained point from where it should be.
    double constraintError() const { return m_constraintError; }
    int evaluations() const { return m_evaluations; }
    const SolverStatistics& statistics() const { return m_solver.statistics(); }

  private:
    using Targets = Points<Dim>;  // one column per constrained point
    Targets moved(const Targets& start, const std::vector<int>& handles, const AffineMap<Dim>& map) const;
    double firstPart(const Targets& displacement) const;
    bool step(const Targets& targets);
    bool solve(const Points<Dim>& shape, const Targets& displacement, Points<Dim>& field);
    bool moves(const Points<Dim>& field, const Targets& displacement) const;
    void prepare();
    void publish();
    std::string describe(const SolveOutcome& failure, const std::vector<int>& handles) const;

    Normalization<Dim> m_units;
    std::shared_ptr<const SimplicialMesh<Dim>> m_domainRest, m_rest;
    std::vector<Twin> m_twins;
    Orientation<Dim> m_orientation;
    Constraints<Dim> m_constraints;
    VelocitySolver<Dim> m_solver;
    VelocityHistory<Dim> m_history;
    double m_memory;  // ρ
    Points<Dim> m_shape, m_pose;
    Targets m_targets;
    SolveOutcome m_failure;
    double m_constraintError = 0;
    int m_evaluations = 0;
};

}  // namespace wend
