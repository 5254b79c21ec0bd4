#include "app/document/handle_edits.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/mesh/plane_geometry.h"

namespace wend {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Design<2>& design(Project& project) {
    return std::get<Design<2>>(project.design);
}
const Design<2>& design(const Project& project) {
    return std::get<Design<2>>(project.design);
}

/// Times in [start, start + 1] in proportion to the length of the path.
std::vector<double> timesByLength(const std::vector<Vec<2>>& path, double start) {
    std::vector<double> times(path.size(), start);
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        length += (path[i] - path[i - 1]).norm();
        times[i] = length;
    }
    for (std::size_t i = 1; i < path.size(); ++i) times[i] = start + times[i] / length;
    times.back() = start + 1;
    return times;
}

Motion<2> recorded(const Vec<2>& from, const std::vector<Vec<2>>& offsets, double start) {
    Recorded<2> stroke{timesByLength(offsets, start), {}};
    for (const Vec<2>& offset : offsets) stroke.points.push_back(from + offset);
    Motion<2> motion;
    motion.kind = std::move(stroke);
    motion.start = start;
    motion.end = start + 1;
    return motion;
}

void keepFarthest(const std::vector<Vec<2>>& path, std::size_t first, std::size_t last, double tolerance,
                  std::vector<bool>& keep) {
    double worst = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double d = distanceToSegment(path[i], path[first], path[last]);
        if (d > worst) worst = d, at = i;
    }
    if (at == first) return;
    keep[at] = true;
    keepFarthest(path, first, at, tolerance, keep);
    keepFarthest(path, at, last, tolerance, keep);
}

template <class T, class Same>
bool sameList(const std::vector<T>& a, const std::vector<T>& b, Same same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool samePoints(const std::vector<Vec<2>>& a, const std::vector<Vec<2>>& b) {
    return sameList(a, b, [](const Vec<2>& p, const Vec<2>& q) { return p == q; });
}

bool same(const Polygon& a, const Polygon& b) {
    return samePoints(a.points, b.points);
}
bool same(const Ball<2>& a, const Ball<2>& b) {
    return a.centre == b.centre && a.radius == b.radius;
}
bool same(const Box<2>& a, const Box<2>& b) {
    return a.min == b.min && a.max == b.max;
}
bool same(const HalfSpace<2>& a, const HalfSpace<2>& b) {
    return a.point == b.point && a.normal == b.normal;
}
bool same(const Blend<2>& a, const Blend<2>& b) {
    return a.from == b.from && a.to == b.to;
}
bool same(const Translate<2>& a, const Translate<2>& b) {
    return a.by == b.by;
}
bool same(const Rotate<2>& a, const Rotate<2>& b) {
    return a.centre == b.centre && a.angle == b.angle;
}
bool same(const CurveMotion<2>& a, const CurveMotion<2>& b) {
    return a.interpolation == b.interpolation && samePoints(a.points, b.points) && a.frame == b.frame &&
           a.twist == b.twist && a.scale == b.scale;
}
bool same(const Recorded<2>& a, const Recorded<2>& b) {
    return a.times == b.times && samePoints(a.points, b.points);
}
bool same(const std::vector<int>& a, const std::vector<int>& b) {
    return a == b;
}
bool same(const std::vector<Vec<2>>& a, const std::vector<Vec<2>>& b) {
    return samePoints(a, b);
}

template <class... T>
bool same(const std::variant<T...>& a, const std::variant<T...>& b) {
    if (a.index() != b.index()) return false;
    return std::visit(
        [&b](const auto& value) { return same(value, std::get<std::decay_t<decltype(value)>>(b)); }, a);
}

bool sameMotion(const Motion<2>& a, const Motion<2>& b) {
    return a.start == b.start && a.end == b.end && a.ease == b.ease && same(a.kind, b.kind);
}

double firstDifference(const Handle<2>& a, const Handle<2>& b) {
    if (!same(a.at, b.at) || a.activeFrom != b.activeFrom) return std::min(a.activeFrom, b.activeFrom);
    double first = a.activeTo == b.activeTo ? kInfinity : std::min(a.activeTo, b.activeTo);
    const std::size_t common = std::min(a.motions.size(), b.motions.size());
    std::size_t i = 0;
    while (i < common && sameMotion(a.motions[i], b.motions[i])) ++i;
    if (i < a.motions.size()) first = std::min(first, a.motions[i].start);
    if (i < b.motions.size()) first = std::min(first, b.motions[i].start);
    return first;
}

}  // namespace

bool hasMotion(const Design<2>& design) {
    return std::any_of(design.handles.begin(), design.handles.end(),
                       [](const auto& h) { return !h.motions.empty(); });
}

double motionEnd(const Project& project) {
    return hasMotion(design(project)) ? project.end : 0;
}

bool isActive(const Handle<2>& handle, double t) {
    return handle.activeFrom <= t && t < handle.activeTo;
}

bool samePlace(const Handle<2>& a, const Handle<2>& b) {
    return same(a.at, b.at);
}

std::string freePinName(const Design<2>& design) {
    std::set<std::string> taken;
    for (const auto& handle : design.handles) taken.insert(handle.name);
    for (int i = 1;; ++i) {
        const std::string name = "Pin " + std::to_string(i);
        if (!taken.count(name)) return name;
    }
}

Project withPin(const Project& project, const Vec<2>& rest, const std::string& name) {
    Project next = project;
    Handle<2> handle;
    handle.name = name;
    handle.at = std::vector<Vec<2>>{rest};
    if (hasMotion(design(project))) handle.activeFrom = project.end;
    design(next).handles.push_back(std::move(handle));
    return next;
}

Project withoutHandles(const Project& project, const std::vector<int>& handles) {
    Project next = project;
    const double end = motionEnd(project);
    const bool moved = hasMotion(design(project));
    std::vector<Handle<2>> kept;
    for (std::size_t i = 0; i < design(project).handles.size(); ++i) {
        Handle<2> handle = design(project).handles[i];
        const bool removed = std::find(handles.begin(), handles.end(), static_cast<int>(i)) != handles.end();
        if (removed && (!moved || handle.activeFrom >= end)) continue;
        if (removed) handle.activeTo = std::min(handle.activeTo, end);
        kept.push_back(std::move(handle));
    }
    design(next).handles = std::move(kept);
    return next;
}

Project withStroke(const Project& project, const std::vector<int>& handles, const std::vector<Vec<2>>& starts,
                   const std::vector<Vec<2>>& offsets) {
    Project next = project;
    const double start = motionEnd(project);
    for (std::size_t i = 0; i < handles.size(); ++i)
        design(next).handles.at(handles[i]).motions.push_back(recorded(starts[i], offsets, start));
    next.end = start + 1;
    return next;
}

Project withLongerStroke(const Project& project, const std::vector<int>& handles, const Vec<2>& step) {
    Project next = project;
    for (const int h : handles) {
        Motion<2>& motion = design(next).handles.at(h).motions.back();
        std::vector<Vec<2>> path = std::get<Recorded<2>>(motion.kind).points;
        const Vec<2> from = path.front();
        path.push_back(path.back() + step);
        for (Vec<2>& p : path) p -= from;
        motion = recorded(from, simplified(path, 0), motion.start);
    }
    return next;
}

std::vector<Vec<2>> simplified(const std::vector<Vec<2>>& path, double tolerance) {
    std::vector<Vec<2>> distinct;
    for (const Vec<2>& p : path)
        if (distinct.empty() || p != distinct.back()) distinct.push_back(p);
    if (distinct.size() < 3) return distinct;
    std::vector<bool> keep(distinct.size(), false);
    keep.front() = keep.back() = true;
    keepFarthest(distinct, 0, distinct.size() - 1, tolerance, keep);
    std::vector<Vec<2>> result;
    for (std::size_t i = 0; i < distinct.size(); ++i)
        if (keep[i]) result.push_back(distinct[i]);
    return result;
}

double firstDifference(const std::vector<Handle<2>>& a, const std::vector<Handle<2>>& b) {
    const std::size_t common = std::min(a.size(), b.size());
    double first = kInfinity;
    for (std::size_t i = 0; i < common; ++i) first = std::min(first, firstDifference(a[i], b[i]));
    for (std::size_t i = common; i < a.size(); ++i) first = std::min(first, a[i].activeFrom);
    for (std::size_t i = common; i < b.size(); ++i) first = std::min(first, b[i].activeFrom);
    return first;
}

}  // namespace wend
