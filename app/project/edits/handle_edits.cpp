#include "app/project/edits/handle_edits.h"

#include <algorithm>
#include <limits>

#include "app/project/edits/document.h"
#include "app/project/edits/film_time.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/handle_comparison.h"
#include "app/project/edits/layer_edits.h"
#include "app/project/project.h"
#include "core/mesh/segments.h"

namespace wend {

namespace {

// Minimum fraction of the film that a gesture gets, and that it leaves to others.
constexpr double kMinTimeShare = 0.002;
// Length of a gesture after motions that the user has timed.
constexpr double kAppended = 1;

/// Times in [start, end] in proportion to the length of the path.
std::vector<double> timesByLength(const std::vector<Vec3>& path, double start, double end) {
    std::vector<double> times(path.size(), 0.0);
    for (std::size_t i = 1; i < path.size(); ++i) times[i] = times[i - 1] + (path[i] - path[i - 1]).norm();
    const double length = times.back();
    for (double& time : times) time = start + time / length * (end - start);
    times.back() = end;
    return times;
}

/// Times of a stroke run from 0 to 1, so its interval can be moved.
PinMotion recorded(const Vec3& from, const std::vector<Amount>& path, const std::vector<double>& times) {
    Recorded<3> stroke;
    const double start = times.front(), length = times.back() - start;
    for (const double time : times) stroke.times.push_back((time - start) / length);
    for (const Amount& amount : path) stroke.points.push_back(from + amount);
    PinMotion motion;
    motion.kind = std::move(stroke);
    motion.start = times.front();
    motion.end = times.back();
    return motion;
}

CurveMotion<3> drawn(const Vec3& from, const std::vector<Amount>& curve) {
    CurveMotion<3> motion;
    for (const Amount& amount : curve) motion.points.push_back(from + amount);
    return motion;
}

template <int Size>
void keepFarthest(const std::vector<Vec<Size>>& path, std::size_t first, std::size_t last, double tolerance,
                  std::vector<bool>& keep) {
    double worst = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double d = distanceToSegment<Size>(path[i], path[first], path[last]);
        if (d > worst) worst = d, at = i;
    }
    if (at == first) return;
    keep[at] = true;
    keepFarthest<Size>(path, first, at, tolerance, keep);
    keepFarthest<Size>(path, at, last, tolerance, keep);
}

}  // namespace

bool hasMotion(const Design& design) {
    return std::any_of(design.handles.begin(), design.handles.end(),
                       [](const auto& h) { return !h.motions.empty(); });
}

bool movesAfter(const Design& design, double time) {
    return std::any_of(design.handles.begin(), design.handles.end(), [time](const auto& handle) {
        return !handle.motions.empty() && handle.motions.back().end > time &&
               !sameTime(handle.motions.back().end, time);
    });
}

double motionEnd(const Project& project) {
    return hasMotion(designOf(project)) ? project.end : 0;
}

bool takesTheEnd(const Project& project, double from) {
    const double end = motionEnd(project);
    return from >= end || sameTime(from, end);
}

bool isActive(const Pin& handle, double t) {
    return handle.activeFrom <= t && t < handle.activeTo;
}

Design withHandle(const Design& design, Placement<3> at, const std::string& name, double time,
                  const std::string& part) {
    Design next = design;
    Pin handle;
    handle.name = name;
    handle.part = part;
    handle.at = std::move(at);
    if (time > 0 && hasMotion(design)) handle.activeFrom = time;
    next.handles.push_back(std::move(handle));
    return next;
}

Design withHandlePlace(const Design& design, int handle, Placement<3> at) {
    Design next = design;
    next.handles.at(handle).at = std::move(at);
    return next;
}

Project withHandleName(const Project& project, int handle, const std::string& name) {
    Project next = project;
    const std::string before = std::exchange(next.design.handles.at(handle).name, name);
    for (ValueLayer& layer : next.depth)  // the order that it gives
        if (!before.empty() && layer.name == before) layer.name = name;
    return next;
}

Project withDepthName(const Project& project, Id layer, const std::string& wish) {
    Project next = project;
    const ValueLayer* own = layerOf(project.depth, layer);
    if (!own) return next;
    std::vector<std::string> taken = namesOf(next.design.handles);
    std::erase(taken, own->name);
    next.depth = withLayerName(project.depth, layer, wish, taken);
    const std::string name = layerOf(next.depth, layer)->name;
    bool isOfHandle = false;
    for (Pin& handle : next.design.handles)
        if (!own->name.empty() && handle.name == own->name) handle.name = name, isOfHandle = true;
    for (ValueLayer& other : next.depth)  // all that the handle gives
        if (isOfHandle && other.name == own->name) other.name = name;
    return next;
}

void renameHandle(Document& document, const QString& step, int handle, const std::string& name) {
    document.change(step, withHandleName(*document.project(), handle, name));
}

void renameDepth(Document& document, const QString& step, Id layer, const std::string& wish) {
    document.change(step, withDepthName(*document.project(), layer, wish));
}

namespace {

void letGo(Design& design, const std::vector<int>& handles, double time) {
    const bool moved = hasMotion(design);
    std::vector<Pin> kept;
    for (std::size_t i = 0; i < design.handles.size(); ++i) {
        Pin handle = design.handles[i];
        const bool removed = std::find(handles.begin(), handles.end(), static_cast<int>(i)) != handles.end();
        const bool hasActed = moved && time > 0 && handle.activeFrom < time;
        if (removed && (!hasActed || handle.activeTo <= time)) continue;
        if (removed) {
            endMotionsAt(handle, time);
            handle.activeTo = time;
        }
        kept.push_back(std::move(handle));
    }
    design.handles = std::move(kept);
}

/// Returns consecutive motions along the path; none for pauses.
std::vector<PinMotion> motionsAlong(const Grip& grip, const std::vector<Amount>& path,
                                    const std::vector<double>& times) {
    std::vector<PinMotion> motions;
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (path[i] == path[i - 1]) continue;
        PinMotion motion = motionBetween(grip, path[i - 1], path[i]);
        motion.start = times[i - 1];
        motion.end = times[i];
        motions.push_back(std::move(motion));
    }
    return motions;
}

double gestureLength(const Gesture& gesture) {
    double length = 0;
    for (std::size_t i = 1; i < gesture.path.size(); ++i)
        length += (gesture.path[i] - gesture.path[i - 1]).norm();
    return gesture.grip.kind == Grip::Kind::Move ? length : gesture.arm * length;
}

/// Returns the time at which earlier motion ends and a gesture of path length `added` begins.
double breakpointAfter(double before, double added, double end) {
    return end * std::clamp(before / (before + added), kMinTimeShare, 1 - kMinTimeShare);
}

/// A project with time for a gesture, and the time of each point of its path.
struct Room {
    Project project;
    std::vector<double> times;
};

/// Appends the gesture: earlier motion shrinks in proportion to the path lengths, unless the user has timed
/// it (`isTimed`). Then the film becomes longer.
Room roomAtTheEnd(const Project& project, const Gesture& gesture, bool isTimed) {
    const auto timed = [&](Project before, double begin) -> Room {
        return {std::move(before), timesByLength(gesture.path, begin, project.end)};
    };
    if (!hasMotion(designOf(project))) return timed(project, 0);
    Project before = endedAt(project, gesture.from);
    if (gesture.from <= 0) return timed(std::move(before), 0);
    if (isTimed) {  // what was timed keeps its times
        before.end = gesture.from + kAppended;
        return {std::move(before), timesByLength(gesture.path, gesture.from, gesture.from + kAppended)};
    }
    const double length = pathLength(before.design.handles, gesture.arm);
    const double breakpoint = breakpointAfter(length, gestureLength(gesture), project.end);
    return timed(withTimesMoved(std::move(before), gesture.from, breakpoint), breakpoint);
}

/// Adds the gesture parallel to the others, which keep their times. Its handles hold as long as they move.
Room roomBeside(const Project& project, const Gesture& gesture, std::vector<double> times) {
    Room room{project, std::move(times)};
    const double end = room.times.back();
    room.project.end = hasMotion(designOf(project)) ? std::max(project.end, end) : end;
    for (const int h : gesture.handles) {
        Pin& handle = room.project.design.handles.at(h);
        endMotionsAt(handle, gesture.from);
        if (handle.activeTo < end) handle.activeTo = std::numeric_limits<double>::infinity();
    }
    return room;
}

Room roomFor(const Project& project, const Gesture& gesture, bool isTimed) {
    std::vector<double> times = gesture.times;
    for (double& time : times) time += gesture.from;
    if (!times.empty()) return roomBeside(project, gesture, std::move(times));
    if (gesture.endsAll || takesTheEnd(project, gesture.from)) return roomAtTheEnd(project, gesture, isTimed);
    return roomBeside(project, gesture, timesByLength(gesture.path, gesture.from, project.end));
}

Project withGestureIn(const Project& project, const Gesture& gesture, const std::vector<Vec3>& starts,
                      bool isTimed) {
    auto [next, times] = roomFor(project, gesture, isTimed);
    for (std::size_t i = 0; i < gesture.handles.size(); ++i) {
        auto& own = next.design.handles.at(gesture.handles[i]).motions;
        if (gesture.grip.kind == Grip::Kind::Move) {
            own.push_back(recorded(starts[i], gesture.path, times));
            if (!gesture.curve.empty()) own.back().kind = drawn(starts[i], gesture.curve);
            continue;
        }
        const auto motions = motionsAlong(gesture.grip, gesture.path, times);
        own.insert(own.end(), motions.begin(), motions.end());
    }
    return next;
}

}  // namespace

Design withoutHandles(const Design& design, const std::vector<int>& handles, double time) {
    Design next = design;
    letGo(next, handles, time);
    return next;
}

Project withStroke(const Project& project, const std::vector<int>& handles, const std::vector<Vec3>& starts,
                   const std::vector<Vec3>& offsets) {
    Gesture gesture{handles, {}, {}, motionEnd(project)};
    for (const Vec3& offset : offsets) gesture.path.push_back(offset);
    return withGesture(project, gesture, starts);
}

Project withLongerStroke(const Project& project, const std::vector<int>& handles, const Vec3& step,
                         double arm, bool atTheEnd) {
    Project before = project;
    std::vector<Vec3> starts, offsets;
    double start = project.end;
    for (const int h : handles) {
        auto& motions = before.design.handles.at(h).motions;
        const std::vector<Vec3> points = std::get<Recorded<3>>(motions.back().kind).points;
        starts.push_back(points.front());
        offsets.clear();
        for (const Vec3& p : points) offsets.push_back(p - points.front());
        start = motions.back().start;
        motions.pop_back();
    }
    offsets.push_back(offsets.back() + step);
    Gesture gesture{handles, {}, {}, start, arm};
    gesture.endsAll = atTheEnd;
    for (const Vec3& offset : simplified<3>(offsets, 0)) gesture.path.push_back(offset);
    return withGestureIn(before, gesture, starts, hasOwnTiming(project));
}

Project withGesture(const Project& project, const Gesture& gesture, const std::vector<Vec3>& starts) {
    return withGestureIn(project, gesture, starts, hasOwnTiming(project));
}

template <int Size>
std::vector<Vec<Size>> simplified(const std::vector<Vec<Size>>& path, double tolerance) {
    std::vector<Vec<Size>> distinct;
    for (const Vec<Size>& p : path)
        if (distinct.empty() || p != distinct.back()) distinct.push_back(p);
    if (distinct.size() < 3) return distinct;
    std::vector<bool> keep(distinct.size(), false);
    keep.front() = keep.back() = true;
    keepFarthest<Size>(distinct, 0, distinct.size() - 1, tolerance, keep);
    std::vector<Vec<Size>> result;
    for (std::size_t i = 0; i < distinct.size(); ++i)
        if (keep[i]) result.push_back(distinct[i]);
    return result;
}

std::shared_ptr<const Project> withNames(const std::shared_ptr<const Project>& project,
                                         const std::function<std::string(const std::string&)>& nameOf) {
    auto renamed = std::make_shared<Project>(*project);
    bool differs = false;
    const auto rename = [&](std::string& name) {
        const std::string next = nameOf(name);
        differs = differs || next != name;
        name = next;
    };
    for (Pin& handle : renamed->design.handles) rename(handle.name);
    for (MaterialLayer& layer : renamed->design.material.layers) rename(layer.name);
    return differs ? renamed : project;
}

template std::vector<Vec2> simplified<2>(const std::vector<Vec2>&, double);
template std::vector<Vec3> simplified<3>(const std::vector<Vec3>&, double);
template std::vector<Vec<4>> simplified<4>(const std::vector<Vec<4>>&, double);  // with times

}  // namespace wend
