#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/motion/guide_surface.h"
#include "core/motion/normalization.h"
#include "core/motion/trajectory.h"

namespace wend {

/// A point of the shape that a handle moves: Σ weight · x_vertex (one vertex, or the barycentric coordinates
/// in a cell).
struct ConstrainedPoint {
    int handle = 0;
    std::vector<std::pair<int, double>> terms;
    bool slides = false;  // it is held in some directions only, see Constraints::heldPart()
    /// The part of a surface on which the point slides, and the number of the normal along which it is held
    /// there. A vertex with several normals has a point for each.
    Track track = Track::None;
    int normal = 0;

    bool isGuided() const { return track != Track::None; }

    /// Returns the place of the point in a shape (Dim × n).
    template <int Dim>
    Vec<Dim> in(const Points<Dim>& shape) const {
        if (terms.size() == 1) return shape.col(terms.front().first);
        Vec<Dim> p = Vec<Dim>::Zero();
        for (const auto& [vertex, weight] : terms) p += weight * shape.col(vertex);
        return p;
    }
};

/// Evaluates a handle over time: its consecutive motions and its active range.
template <int Dim>
class HandleTimeline {
  public:
    /// Throws InputError for invalid motions, motions out of order or overlapping, and an empty active range.
    explicit HandleTimeline(const Handle<Dim>& handle);

    /// Returns whether the handle is active.
    bool active(double t, Side side) const;
    /// Returns the active motion, or −1 if the handle holds still or is inactive.
    int motionAt(double t, Side side) const;
    /// Returns the map from a point's place at the start of the current motion to its place at t; identity if
    /// the handle holds still.
    MovingMap<Dim> at(double t, Side side) const;
    /// Returns the map from the rest place of a body that follows all motions to its place at t, and to its
    /// velocity. Between motions and after the last one the velocity is 0; the active range does not count.
    MovingMap<Dim> bodyAt(double t, Side side) const;
    /// Returns all times at which the constraints or their velocities are not smooth. They are not sorted,
    /// and may contain a time more than once.
    std::vector<double> breakpoints() const;

  private:
    std::vector<Trajectory<Dim>> m_motions;
    double m_activeFrom, m_activeTo;
};

/// The points that handles prescribe, with their trajectories.
/// A constrained point's *anchor* at time t is its place when the motion that acts from t on began (or its
/// place, if the handle holds still): its trajectory is M(t′) anchor. A handle that becomes active later,
/// possibly in the middle of a motion, takes its points from where they are then.
template <int Dim>
class Constraints {
  public:
    using Anchors = std::vector<Vec<Dim>>;

    /// Rest and handles in one frame; `units` says how to print its points. Throws InputError naming the
    /// handle: a point outside the shape, a vertex id out of range, a region without a vertex, no point at
    /// all, motions as in HandleTimeline, a surface to slide on that is farther than 1 % of the size. Points
    /// of several handles at one place are kept apart; whether they agree is for requireConsistent() to say.
    /// No handle gives no points.
    Constraints(const SimplicialMesh<Dim>& rest, const std::vector<Handle<Dim>>& handles,
                const Normalization<Dim>& units = {});

    /// Returns all points; those that slide come last.
    const std::vector<ConstrainedPoint>& points() const { return m_points; }
    /// Returns the welds of the mesh, which hold at all times.
    const std::vector<Weld>& welds() const { return m_welds; }
    /// Says how the points of a handle are held: along `normal` (of length 1) if there is one, else in the
    /// coordinates whose bits are set in `held`. For points that do not slide that is all of them. Points on
    /// a surface are held along its normals, see guide().
    struct Hold {
        unsigned held = 0;
        std::optional<Vec<Dim>> normal;
        std::shared_ptr<const GuideSurface<Dim>> surface;
    };
    const Hold& hold(int handle) const { return m_holds[static_cast<size_t>(handle)]; }
    /// Returns the part of a vector along the directions in which the points of a handle are held; on a
    /// surface the whole vector.
    Vec<Dim> heldPart(int handle, const Vec<Dim>& v) const;
    /// Returns the part of a difference from the prescribed place or velocity in the directions that are
    /// held.
    Vec<Dim> deviation(int id, const Vec<Dim>& difference) const {
        const ConstrainedPoint& point = m_points[static_cast<size_t>(id)];
        return point.slides ? heldPart(point.handle, difference) : difference;
    }
    const HandleTimeline<Dim>& timeline(int handle) const { return m_timelines[handle]; }
    /// Returns `handle "name"`, with the number if it has no name.
    const Message& handleName(int handle) const { return m_names[handle]; }

    /// Returns the sorted times that no step may cross: windows, breaks of velocity, active ranges.
    const std::vector<double>& breakpoints() const { return m_breakpoints; }
    /// Returns the first breakpoint after t, or +infinity.
    double nextBreakpoint(double t) const;
    /// Returns the last breakpoint up to t, or −infinity.
    double lastBreakpoint(double t) const;

    /// Return the active points that are held in all directions, and those that slide (vertices).
    std::vector<int> activePoints(double t, Side side) const;
    std::vector<int> activeSliders(double t, Side side) const;
    /// Returns whether any active handle moves.
    bool moving(double t, Side side) const;

    /// Returns the anchor of a point that is at p at time t. It is M(t)⁻¹ p with the map M of the motion that
    /// acts there, and p itself if the handle holds still.
    Vec<Dim> anchor(int id, const Vec<Dim>& p, double t, Side side = Side::After) const;
    /// Returns anchors for continuing from a shape at time t.
    Anchors anchors(const Points<Dim>& shape, double t, Side side = Side::After) const;
    /// Updates anchors across the breakpoint t.
    void crossBreakpoint(double t, const Points<Dim>& shape, Anchors& anchors) const;
    /// Returns anchors for continuing from a shape at time t, given those of other constraints at that time:
    /// kept to the bit for points that were constrained before on the same trajectory, else as anchors().
    Anchors adopt(const std::vector<ConstrainedPoint>& others, const Anchors& theirs,
                  const Points<Dim>& shape, double t) const;

    /// Computes positions and velocities of some points at time t, one column each. For points that slide,
    /// the velocity is its held part, and only the held part of the position counts. The columns (Dim ×
    /// number of ids) are in the order of the ids; `anchors` has an entry for every point, used or not.
    /// Velocities are the analytic derivatives of the positions.
    void evaluate(const std::vector<int>& ids, const Anchors& anchors, double t, Side side,
                  Points<Dim>& positions, Points<Dim>& velocities) const;

    /// Returns whether any point slides on a surface.
    bool hasGuides() const { return !m_restNormals.empty(); }
    /// Returns the direction at rest in which a point that slides on a surface is held.
    const Vec<Dim>& restNormal(int id) const { return m_restNormals[static_cast<size_t>(id)]; }
    /// Replaces the positions of points that slide on surfaces by the nearest places of the surfaces at time
    /// t, and their velocities by the held parts of the surfaces' velocities there. `normals` gets the
    /// directions in which they are held, one column per id; those of other points are 0.
    void guide(const std::vector<int>& ids, const Points<Dim>& shape, double t, Side side,
               Points<Dim>& positions, Points<Dim>& velocities, Points<Dim>& normals) const;
    /// Moves the vertices of such points to the nearest places of their surfaces. Returns the greatest
    /// distance. Points are moved one after another in the order of the ids; 0 without such points.
    double pull(const std::vector<int>& ids, double t, Side side, Points<Dim>& shape) const;

  private:
    /// Maps a handle's anchors to its points, by the motion with that number (−1: it holds still).
    struct HandleMap {
        MovingMap<Dim> map;
        int motion = -1;
    };
    void take(std::vector<ConstrainedPoint> points, const Handle<Dim>& handle,
              std::shared_ptr<const GuideSurface<Dim>> surface);
    void findRestNormals(const Points<Dim>& rest);
    template <class Visit>
    void forContacts(const std::vector<int>& ids, const Points<Dim>& shape, double t, Side side,
                     Visit&& visit) const;
    std::vector<int> active(double t, Side side, bool slide) const;
    void takeFields(const std::vector<Handle<Dim>>& handles);
    std::vector<HandleMap> maps(double t, Side side) const;
    Vec<Dim> displacement(size_t id, int motion) const;
    Vec<Dim> place(const HandleMap& map, size_t id, const Vec<Dim>& anchor) const;
    Vec<Dim> anchorAt(const HandleMap& map, size_t id, const Vec<Dim>& p) const;

    std::vector<ConstrainedPoint> m_points;
    std::vector<Weld> m_welds;
    /// The displacements of every point by FieldMotions, by the number of the motion; empty if there are
    /// none.
    std::vector<std::vector<Vec<Dim>>> m_displacements;
    std::vector<Hold> m_holds;            // per handle
    std::vector<Vec<Dim>> m_restNormals;  // per point; empty if none slides on a surface
    std::vector<HandleTimeline<Dim>> m_timelines;
    std::vector<Message> m_names;
    std::vector<double> m_breakpoints;
};

}  // namespace wend
