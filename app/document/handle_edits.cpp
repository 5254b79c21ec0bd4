#include "app/document/handle_edits.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/mesh/segments.h"

namespace wend {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <int Dim>
Design<Dim>& design(Project& project) {
    return std::get<Design<Dim>>(project.design);
}
template <int Dim>
const Design<Dim>& design(const Project& project) {
    return std::get<Design<Dim>>(project.design);
}

template <int Dim>
double endOf(const Project& project) {
    return hasMotion(design<Dim>(project)) ? project.end : 0;
}

/// Times in [start, start + 1] in proportion to the length of the path.
template <int Dim>
std::vector<double> timesByLength(const std::vector<Vec<Dim>>& path, double start) {
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

template <int Dim>
Motion<Dim> recorded(const Vec<Dim>& from, const std::vector<Vec<Dim>>& offsets, double start) {
    Recorded<Dim> stroke{timesByLength<Dim>(offsets, start), {}};
    for (const Vec<Dim>& offset : offsets) stroke.points.push_back(from + offset);
    Motion<Dim> motion;
    motion.kind = std::move(stroke);
    motion.start = start;
    motion.end = start + 1;
    return motion;
}

template <int Dim>
void keepFarthest(const std::vector<Vec<Dim>>& path, std::size_t first, std::size_t last, double tolerance,
                  std::vector<bool>& keep) {
    double worst = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double d = distanceToSegment<Dim>(path[i], path[first], path[last]);
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

template <int Dim>
bool samePoints(const std::vector<Vec<Dim>>& a, const std::vector<Vec<Dim>>& b) {
    return sameList(a, b, [](const Vec<Dim>& p, const Vec<Dim>& q) { return p == q; });
}

bool same(const Polygon& a, const Polygon& b) {
    return samePoints<2>(a.points, b.points);
}
template <int Dim>
bool same(const Ball<Dim>& a, const Ball<Dim>& b) {
    return a.centre == b.centre && a.radius == b.radius;
}
template <int Dim>
bool same(const Box<Dim>& a, const Box<Dim>& b) {
    return a.min == b.min && a.max == b.max;
}
template <int Dim>
bool same(const HalfSpace<Dim>& a, const HalfSpace<Dim>& b) {
    return a.point == b.point && a.normal == b.normal;
}
template <int Dim>
bool same(const Blend<Dim>& a, const Blend<Dim>& b) {
    return a.from == b.from && a.to == b.to;
}
template <int Dim>
bool same(const Translate<Dim>& a, const Translate<Dim>& b) {
    return a.by == b.by;
}
template <int Dim>
bool same(const Rotate<Dim>& a, const Rotate<Dim>& b) {
    return a.centre == b.centre && a.axis == b.axis && a.angle == b.angle;
}
template <int Dim>
bool same(const CurveMotion<Dim>& a, const CurveMotion<Dim>& b) {
    return a.interpolation == b.interpolation && samePoints<Dim>(a.points, b.points) && a.frame == b.frame &&
           a.twist == b.twist && a.scale == b.scale;
}
template <int Dim>
bool same(const Recorded<Dim>& a, const Recorded<Dim>& b) {
    return a.times == b.times && samePoints<Dim>(a.points, b.points);
}
bool same(const std::vector<int>& a, const std::vector<int>& b) {
    return a == b;
}
template <int Dim>
bool same(const std::vector<Vec<Dim>>& a, const std::vector<Vec<Dim>>& b) {
    return samePoints<Dim>(a, b);
}

template <class... T>
bool same(const std::variant<T...>& a, const std::variant<T...>& b) {
    if (a.index() != b.index()) return false;
    return std::visit(
        [&b](const auto& value) { return same(value, std::get<std::decay_t<decltype(value)>>(b)); }, a);
}

template <int Dim>
bool sameMotion(const Motion<Dim>& a, const Motion<Dim>& b) {
    return a.start == b.start && a.end == b.end && a.ease == b.ease && same(a.kind, b.kind);
}

template <int Dim>
double differenceOf(const Handle<Dim>& a, const Handle<Dim>& b) {
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

template <int Dim>
bool hasMotion(const Design<Dim>& design) {
    return std::any_of(design.handles.begin(), design.handles.end(),
                       [](const auto& h) { return !h.motions.empty(); });
}

double motionEnd(const Project& project) {
    return project.dimension() == 2 ? endOf<2>(project) : endOf<3>(project);
}

template <int Dim>
bool isActive(const Handle<Dim>& handle, double t) {
    return handle.activeFrom <= t && t < handle.activeTo;
}

template <int Dim>
bool samePlace(const Handle<Dim>& a, const Handle<Dim>& b) {
    return same(a.at, b.at);
}

template <int Dim>
std::string freePinName(const Design<Dim>& design, const std::string& kind) {
    std::set<std::string> taken;
    for (const auto& handle : design.handles) taken.insert(handle.name);
    for (int i = 1;; ++i) {
        const std::string name = kind + " " + std::to_string(i);
        if (!taken.count(name)) return name;
    }
}

template <int Dim>
Project withHandle(const Project& project, Placement<Dim> at, const std::string& name) {
    Project next = project;
    Handle<Dim> handle;
    handle.name = name;
    handle.at = std::move(at);
    if (hasMotion(design<Dim>(project))) handle.activeFrom = project.end;
    design<Dim>(next).handles.push_back(std::move(handle));
    return next;
}

template <int Dim>
Project withPin(const Project& project, const Vec<Dim>& rest, const std::string& name) {
    return withHandle<Dim>(project, std::vector<Vec<Dim>>{rest}, name);
}

template <int Dim>
Project withHandlePlace(const Project& project, int handle, Placement<Dim> at) {
    Project next = project;
    design<Dim>(next).handles.at(handle).at = std::move(at);
    return next;
}

Project withHandleName(const Project& project, int handle, const std::string& name) {
    Project next = project;
    std::visit([&](auto& own) { own.handles.at(handle).name = name; }, next.design);
    return next;
}

namespace {

template <int Dim>
void letGo(Project& next, const Project& project, const std::vector<int>& handles) {
    const double end = endOf<Dim>(project);
    const bool moved = hasMotion(design<Dim>(project));
    std::vector<Handle<Dim>> kept;
    for (std::size_t i = 0; i < design<Dim>(project).handles.size(); ++i) {
        Handle<Dim> handle = design<Dim>(project).handles[i];
        const bool removed = std::find(handles.begin(), handles.end(), static_cast<int>(i)) != handles.end();
        const bool isGone = handle.activeTo <= end;
        if (removed && (!moved || isGone || handle.activeFrom >= end)) continue;
        if (removed) handle.activeTo = std::min(handle.activeTo, end);
        kept.push_back(std::move(handle));
    }
    design<Dim>(next).handles = std::move(kept);
}

/// Motions that follow each other along the path, in [start, start + 1] in proportion to the way.
template <int Dim>
std::vector<Motion<Dim>> motionsAlong(const Grip& grip, const std::vector<Amount>& path, double start) {
    const std::vector<double> times = timesByLength<3>(path, start);
    std::vector<Motion<Dim>> motions;
    for (std::size_t i = 1; i < path.size(); ++i) {
        Motion<Dim> motion = motionBetween<Dim>(grip, path[i - 1], path[i]);
        motion.start = times[i - 1];
        motion.end = times[i];
        motions.push_back(std::move(motion));
    }
    return motions;
}

}  // namespace

Project withoutHandles(const Project& project, const std::vector<int>& handles) {
    Project next = project;
    if (project.dimension() == 2)
        letGo<2>(next, project, handles);
    else
        letGo<3>(next, project, handles);
    return next;
}

template <int Dim>
Project withStroke(const Project& project, const std::vector<int>& handles,
                   const std::vector<Vec<Dim>>& starts, const std::vector<Vec<Dim>>& offsets) {
    Project next = project;
    const double start = motionEnd(project);
    for (std::size_t i = 0; i < handles.size(); ++i)
        design<Dim>(next).handles.at(handles[i]).motions.push_back(recorded<Dim>(starts[i], offsets, start));
    next.end = start + 1;
    return next;
}

template <int Dim>
Project withLongerStroke(const Project& project, const std::vector<int>& handles, const Vec<Dim>& step) {
    Project next = project;
    for (const int h : handles) {
        Motion<Dim>& motion = design<Dim>(next).handles.at(h).motions.back();
        std::vector<Vec<Dim>> path = std::get<Recorded<Dim>>(motion.kind).points;
        const Vec<Dim> from = path.front();
        path.push_back(path.back() + step);
        for (Vec<Dim>& p : path) p -= from;
        motion = recorded<Dim>(from, simplified<Dim>(path, 0), motion.start);
    }
    return next;
}

template <int Dim>
Project withGesture(const Project& project, const std::vector<int>& handles,
                    const std::vector<Vec<Dim>>& starts, const Grip& grip, const std::vector<Amount>& path) {
    if (grip.kind == Grip::Kind::Move) {
        std::vector<Vec<Dim>> offsets;
        offsets.reserve(path.size());
        for (const Amount& amount : path) offsets.push_back(amount.template head<Dim>());
        return withStroke<Dim>(project, handles, starts, offsets);
    }
    Project next = project;
    const double start = motionEnd(project);
    const auto motions = motionsAlong<Dim>(grip, path, start);
    for (const int h : handles) {
        auto& own = design<Dim>(next).handles.at(h).motions;
        own.insert(own.end(), motions.begin(), motions.end());
    }
    next.end = start + 1;
    return next;
}

template <int Dim>
std::vector<Vec<Dim>> simplified(const std::vector<Vec<Dim>>& path, double tolerance) {
    std::vector<Vec<Dim>> distinct;
    for (const Vec<Dim>& p : path)
        if (distinct.empty() || p != distinct.back()) distinct.push_back(p);
    if (distinct.size() < 3) return distinct;
    std::vector<bool> keep(distinct.size(), false);
    keep.front() = keep.back() = true;
    keepFarthest<Dim>(distinct, 0, distinct.size() - 1, tolerance, keep);
    std::vector<Vec<Dim>> result;
    for (std::size_t i = 0; i < distinct.size(); ++i)
        if (keep[i]) result.push_back(distinct[i]);
    return result;
}

template <int Dim>
double firstDifference(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b) {
    const std::size_t common = std::min(a.size(), b.size());
    double first = kInfinity;
    for (std::size_t i = 0; i < common; ++i) first = std::min(first, differenceOf<Dim>(a[i], b[i]));
    for (std::size_t i = common; i < a.size(); ++i) first = std::min(first, a[i].activeFrom);
    for (std::size_t i = common; i < b.size(); ++i) first = std::min(first, b[i].activeFrom);
    return first;
}

// clang-format off
#define WEND_INSTANTIATE(Dim)                                                                                \
    template bool hasMotion(const Design<Dim>&);                                                             \
    template bool isActive(const Handle<Dim>&, double);                                                      \
    template bool samePlace(const Handle<Dim>&, const Handle<Dim>&);                                         \
    template std::string freePinName(const Design<Dim>&, const std::string&);                                \
    template Project withHandle<Dim>(const Project&, Placement<Dim>, const std::string&);                    \
    template Project withPin<Dim>(const Project&, const Vec<Dim>&, const std::string&);                      \
    template Project withHandlePlace<Dim>(const Project&, int, Placement<Dim>);                              \
    template Project withStroke<Dim>(const Project&, const std::vector<int>&, const std::vector<Vec<Dim>>&,  \
                                     const std::vector<Vec<Dim>>&);                                          \
    template Project withLongerStroke<Dim>(const Project&, const std::vector<int>&, const Vec<Dim>&);        \
    template Project withGesture<Dim>(const Project&, const std::vector<int>&, const std::vector<Vec<Dim>>&, \
                                      const Grip&, const std::vector<Amount>&);                              \
    template std::vector<Vec<Dim>> simplified<Dim>(const std::vector<Vec<Dim>>&, double);                    \
    template double firstDifference<Dim>(const std::vector<Handle<Dim>>&, const std::vector<Handle<Dim>>&)
// clang-format on

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
