#include "core/motion/constraints.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "core/motion/handle_points.h"
#include "core/motion/sliding.h"

namespace wend {

namespace {

/// Returns whether t is in a range, seen from one side of its ends.
bool within(double t, double from, double to, Side side) {
    return side == Side::After ? from <= t && t < to : from < t && t <= to;
}

template <int Dim>
Trajectory<Dim> trajectoryOf(const Motion<Dim>& motion, size_t number) {
    try {
        return Trajectory<Dim>(motion);
    } catch (const InputError& error) {
        throw InputError("motion " + std::to_string(number + 1) + ": " + error.message());
    }
}

/// Returns the displacement of a vertex, by binary search in the ascending numbers; null if there is none.
template <int Dim>
const Vec<Dim>* valueAt(const Displacements<Dim>& values, int vertex) {
    const auto found = std::ranges::lower_bound(values, vertex, {}, &Displacements<Dim>::value_type::first);
    return found != values.end() && found->first == vertex ? &found->second : nullptr;
}

/// Returns x with map(x) = p. A translation is inverted without a matrix, so that what is not rotated keeps
/// its digits.
template <int Dim>
Vec<Dim> preimage(const AffineMap<Dim>& map, const Vec<Dim>& p) {
    if (map.A == Mat<Dim>::Identity()) return p - map.b;
    return map.A.inverse() * (p - map.b);
}

}  // namespace

template <int Dim>
HandleTimeline<Dim>::HandleTimeline(const Handle<Dim>& handle)
    : m_activeFrom(handle.activeFrom), m_activeTo(handle.activeTo) {
    if (!(m_activeFrom < m_activeTo)) throw InputError("\"active\" must be two increasing numbers");
    for (const Motion<Dim>& motion : handle.motions) {
        m_motions.push_back(trajectoryOf(motion, m_motions.size()));
        const size_t last = m_motions.size() - 1;
        if (last > 0 && m_motions[last].start() < m_motions[last - 1].end()) {
            throw InputError("motion " + std::to_string(last + 1) + " begins before motion " +
                             std::to_string(last) + " has ended");
        }
    }
}

template <int Dim>
bool HandleTimeline<Dim>::active(double t, Side side) const {
    return within(t, m_activeFrom, m_activeTo, side);
}

template <int Dim>
int HandleTimeline<Dim>::motionAt(double t, Side side) const {
    if (!active(t, side)) return -1;
    for (size_t i = 0; i < m_motions.size(); ++i) {
        if (within(t, m_motions[i].start(), m_motions[i].end(), side)) return static_cast<int>(i);
    }
    return -1;
}

template <int Dim>
MovingMap<Dim> HandleTimeline<Dim>::at(double t, Side side) const {
    const int motion = motionAt(t, side);
    if (motion < 0) return {{}, {Mat<Dim>::Zero(), Vec<Dim>::Zero()}};
    return m_motions[motion].at(t, side);
}

/// Composes the maps of all motions that have begun.
template <int Dim>
MovingMap<Dim> HandleTimeline<Dim>::bodyAt(double t, Side side) const {
    MovingMap<Dim> body{{}, {Mat<Dim>::Zero(), Vec<Dim>::Zero()}};
    for (const Trajectory<Dim>& motion : m_motions) {
        if (side == Side::After ? t < motion.start() : t <= motion.start()) break;
        const bool hasEnded = !within(t, motion.start(), motion.end(), side);
        const MovingMap<Dim> own = motion.at(std::min(t, motion.end()), hasEnded ? Side::Before : side);
        if (!hasEnded)
            body.velocity = {own.velocity.A * body.position.A,
                             own.velocity.A * body.position.b + own.velocity.b};
        body.position = {own.position.A * body.position.A, own.position(body.position.b)};
    }
    return body;
}

/// Returns the starts, ends and breaks of all motions, and the ends of the active range.
template <int Dim>
std::vector<double> HandleTimeline<Dim>::breakpoints() const {
    std::vector<double> times;
    for (const Trajectory<Dim>& motion : m_motions) {
        times.push_back(motion.start());
        times.insert(times.end(), motion.breakTimes().begin(), motion.breakTimes().end());
        times.push_back(motion.end());
    }
    for (const double t : {m_activeFrom, m_activeTo}) {
        if (std::isfinite(t)) times.push_back(t);
    }
    return times;
}

template <int Dim>
Constraints<Dim>::Constraints(const SimplicialMesh<Dim>& rest, const std::vector<Handle<Dim>>& handles,
                              const Normalization<Dim>& units)
    : m_welds(rest.welds) {
    const HandlePlacer<Dim> placer(rest, units);
    for (size_t i = 0; i < handles.size(); ++i) {
        m_names.push_back(handles[i].name.empty()
                              ? Message(sentence("Core", "handle %1"), i)
                              : Message(sentence("Core", "handle \"%1\""), handles[i].name));
        try {
            m_timelines.emplace_back(handles[i]);
            std::vector<ConstrainedPoint> points = placer.place(handles[i], static_cast<int>(i));
            std::shared_ptr<const GuideSurface<Dim>> surface;
            if (handles[i].slide) surface = surfaceOf(handles[i], points, rest);
            take(surface ? onSurface<Dim>(*surface, points, rest.points) : points, handles[i], surface);
        } catch (const InputError& error) {
            throw InputError(m_names.back() + ": " + error.message());
        }
        const std::vector<double> times = m_timelines.back().breakpoints();
        m_breakpoints.insert(m_breakpoints.end(), times.begin(), times.end());
    }
    std::ranges::stable_partition(m_points, [](const ConstrainedPoint& point) { return !point.slides; });
    takeFields(handles);
    findRestNormals(rest.points);
    std::sort(m_breakpoints.begin(), m_breakpoints.end());
    m_breakpoints.erase(std::unique(m_breakpoints.begin(), m_breakpoints.end()), m_breakpoints.end());
}

/// Appends the points of a handle, with the directions in which they are held.
template <int Dim>
void Constraints<Dim>::take(std::vector<ConstrainedPoint> points, const Handle<Dim>& handle,
                            std::shared_ptr<const GuideSurface<Dim>> surface) {
    constexpr unsigned kAll = (1U << Dim) - 1;
    Hold hold{kAll & ~handle.slides, {}, std::move(surface)};
    if (handle.normal) {
        if (!(handle.normal->allFinite() && handle.normal->norm() > 0))
            throw InputError("the normal of its hold has no direction");
        const Vec<Dim> normal = handle.normal->normalized();
        int axis = 0;
        if (normal.cwiseAbs().maxCoeff(&axis) == 1)
            hold.held = 1U << axis;
        else
            hold.normal = normal;
    }
    m_holds.push_back(hold);
    for (ConstrainedPoint& point : points) {
        point.slides = handle.isPartlyHeld();
        if (point.slides && point.terms.size() > 1) throw InputError("only vertices can slide");
        m_points.push_back(std::move(point));
    }
}

template <int Dim>
Vec<Dim> Constraints<Dim>::heldPart(int handle, const Vec<Dim>& v) const {
    const Hold& hold = m_holds[static_cast<size_t>(handle)];
    if (hold.surface) return v;
    if (hold.normal) return *hold.normal * hold.normal->dot(v);
    Vec<Dim> part = v;
    for (int k = 0; k < Dim; ++k)
        if ((hold.held >> k & 1U) == 0) part[k] = 0;
    return part;
}

/// Takes the displacements of fields. A point inside a cell has those of its vertices, weighted as they are.
template <int Dim>
void Constraints<Dim>::takeFields(const std::vector<Handle<Dim>>& handles) {
    m_displacements.resize(m_points.size());
    for (size_t k = 0; k < m_points.size(); ++k) {
        const auto number = static_cast<size_t>(m_points[k].handle);
        const std::vector<Motion<Dim>>& motions = handles[number].motions;
        for (size_t m = 0; m < motions.size(); ++m) {
            const auto* field = std::get_if<FieldMotion<Dim>>(&motions[m].kind);
            if (!field) continue;
            m_displacements[k].resize(motions.size(), Vec<Dim>::Zero());
            for (const auto& [vertex, weight] : m_points[k].terms) {
                const Vec<Dim>* value = valueAt<Dim>(*field->values, vertex);
                if (!value)
                    throw InputError(m_names[number] + ": motion " + std::to_string(m + 1) +
                                     ": there is no displacement for vertex " + std::to_string(vertex) +
                                     (field->file.empty() ? "" : " in " + field->file));
                m_displacements[k][m] += weight * *value;
            }
        }
    }
}

template <int Dim>
double Constraints<Dim>::nextBreakpoint(double t) const {
    const auto next = std::upper_bound(m_breakpoints.begin(), m_breakpoints.end(), t);
    return next == m_breakpoints.end() ? std::numeric_limits<double>::infinity() : *next;
}

template <int Dim>
double Constraints<Dim>::lastBreakpoint(double t) const {
    const auto next = std::upper_bound(m_breakpoints.begin(), m_breakpoints.end(), t);
    return next == m_breakpoints.begin() ? -std::numeric_limits<double>::infinity() : *(next - 1);
}

template <int Dim>
std::vector<int> Constraints<Dim>::active(double t, Side side, bool slide) const {
    std::vector<int> ids;
    for (size_t k = 0; k < m_points.size(); ++k) {
        if (m_points[k].slides == slide && m_timelines[m_points[k].handle].active(t, side))
            ids.push_back(static_cast<int>(k));
    }
    return ids;
}

template <int Dim>
std::vector<int> Constraints<Dim>::activePoints(double t, Side side) const {
    return active(t, side, false);
}

template <int Dim>
std::vector<int> Constraints<Dim>::activeSliders(double t, Side side) const {
    return active(t, side, true);
}

template <int Dim>
bool Constraints<Dim>::moving(double t, Side side) const {
    return std::any_of(m_timelines.begin(), m_timelines.end(),
                       [&](const HandleTimeline<Dim>& timeline) { return timeline.motionAt(t, side) >= 0; });
}

template <int Dim>
auto Constraints<Dim>::maps(double t, Side side) const -> std::vector<HandleMap> {
    std::vector<HandleMap> result;
    result.reserve(m_timelines.size());
    for (const HandleTimeline<Dim>& timeline : m_timelines)
        result.push_back({timeline.at(t, side), timeline.motionAt(t, side)});
    return result;
}

template <int Dim>
Vec<Dim> Constraints<Dim>::displacement(size_t id, int motion) const {
    if (motion < 0 || m_displacements[id].empty()) return Vec<Dim>::Zero();
    return m_displacements[id][static_cast<size_t>(motion)];
}

template <int Dim>
Vec<Dim> Constraints<Dim>::place(const HandleMap& now, size_t id, const Vec<Dim>& anchor) const {
    const Vec<Dim> p = now.map.position(anchor);
    return now.map.share == 0 ? p : Vec<Dim>(p + now.map.share * displacement(id, now.motion));
}

template <int Dim>
Vec<Dim> Constraints<Dim>::anchorAt(const HandleMap& now, size_t id, const Vec<Dim>& p) const {
    if (now.map.share == 0) return preimage<Dim>(now.map.position, p);
    return preimage<Dim>(now.map.position, p - now.map.share * displacement(id, now.motion));
}

template <int Dim>
Vec<Dim> Constraints<Dim>::anchor(int id, const Vec<Dim>& p, double t, Side side) const {
    const HandleTimeline<Dim>& timeline = m_timelines[m_points[id].handle];
    return anchorAt({timeline.at(t, side), timeline.motionAt(t, side)}, static_cast<size_t>(id), p);
}

template <int Dim>
auto Constraints<Dim>::anchors(const Points<Dim>& shape, double t, Side side) const -> Anchors {
    const std::vector<HandleMap> map = maps(t, side);
    Anchors result;
    for (size_t k = 0; k < m_points.size(); ++k) {
        result.push_back(anchorAt(map[m_points[k].handle], k, m_points[k].in<Dim>(shape)));
    }
    return result;
}

/// Takes new anchors for the points of handles that begin another motion, or become active or inactive, at t;
/// all others keep theirs.
template <int Dim>
void Constraints<Dim>::crossBreakpoint(double t, const Points<Dim>& shape, Anchors& anchors) const {
    const std::vector<HandleMap> before = maps(t, Side::Before), after = maps(t, Side::After);
    for (size_t k = 0; k < m_points.size(); ++k) {
        const int handle = m_points[k].handle;
        const HandleTimeline<Dim>& timeline = m_timelines[handle];
        const bool wasActive = timeline.active(t, Side::Before),
                   staysActive = timeline.active(t, Side::After);
        // A point that slid begins the next motion at its present place.
        if (wasActive && staysActive && !m_points[k].slides) {
            if (timeline.motionAt(t, Side::Before) == timeline.motionAt(t, Side::After)) continue;
            anchors[k] = place(before[handle], k, anchors[k]);  // a motion begins with the identity
        } else if (!(wasActive && staysActive) ||
                   timeline.motionAt(t, Side::Before) != timeline.motionAt(t, Side::After)) {
            anchors[k] = anchorAt(after[handle], k, m_points[k].in<Dim>(shape));
        }
    }
}

/// Finds the points of the other constraints by their terms, and keeps an anchor if both trajectories agree
/// up to rounding.
template <int Dim>
auto Constraints<Dim>::adopt(const std::vector<ConstrainedPoint>& others, const Anchors& theirs,
                             const Points<Dim>& shape, double t) const -> Anchors {
    constexpr double kSameTrajectory =
        1e-9;  // relative to the size, which is 1 in the frame of the computation
    std::multimap<std::vector<std::pair<int, double>>, size_t> known;
    for (size_t i = 0; i < std::min(others.size(), theirs.size()); ++i) known.emplace(others[i].terms, i);
    const std::vector<HandleMap> after = maps(t, Side::After);
    Anchors result = anchors(shape, t);
    for (size_t k = 0; k < m_points.size(); ++k) {
        const auto [first, last] = known.equal_range(m_points[k].terms);
        for (auto it = first; it != last; ++it) {
            const Vec<Dim> p = place(after[m_points[k].handle], k, theirs[it->second]);
            const Vec<Dim> off = deviation(static_cast<int>(k), p - m_points[k].in<Dim>(shape));
            if (off.norm() <= kSameTrajectory) result[k] = theirs[it->second];
            if (others[it->second].handle == m_points[k].handle) break;
        }
    }
    return result;
}

template <int Dim>
void Constraints<Dim>::evaluate(const std::vector<int>& ids, const Anchors& anchors, double t, Side side,
                                Points<Dim>& positions, Points<Dim>& velocities) const {
    const std::vector<HandleMap> now = maps(t, side);
    positions.resize(Dim, static_cast<Eigen::Index>(ids.size()));
    velocities.resize(Dim, static_cast<Eigen::Index>(ids.size()));
    for (size_t i = 0; i < ids.size(); ++i) {
        const auto id = static_cast<size_t>(ids[i]);
        const auto column = static_cast<Eigen::Index>(i);
        const HandleMap& own = now[m_points[id].handle];
        positions.col(column) = place(own, id, anchors[id]);
        velocities.col(column) = own.map.velocity(anchors[id]);
        if (own.map.shareRate != 0)
            velocities.col(column) += own.map.shareRate * displacement(id, own.motion);
        if (m_points[id].slides)
            velocities.col(column) = heldPart(m_points[id].handle, velocities.col(column));
    }
}

template class HandleTimeline<2>;
template class Constraints<2>;
template class HandleTimeline<3>;
template class Constraints<3>;

}  // namespace wend
