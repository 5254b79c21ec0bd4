#include "app/project/edits/timing_edits.h"
#include "app/project/edits/offset_path.h"
#include "app/project/edits/progress.h"
#include "app/project/project.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace wend {

namespace {

/// Calls `edit` with the motions of a handle.
template <class Edit>
Design edited(Design design, int handle, const Edit& edit) {
    edit(design.handles.at(static_cast<std::size_t>(handle)).motions);
    return design;
}

/// Sets the easing. A straight move along a curve of progress becomes an eased one.
void setEase(PinMotion& motion, Ease ease) {
    if (straightProgress(motion)) motion.kind = Translate<3>{*offsetOf(motion)};
    motion.ease = ease;
}

/// Returns the interval in which a motion can be placed: between the other motions of its handle that do not
/// move along, while the handle holds.
MotionTime roomOf(const Design& design, const MotionId& of, const std::vector<MotionId>& along) {
    const auto isLeft = [&](int motion) { return !isAmong(along, MotionId{of.handle, motion}); };
    const Pin& own = design.handles.at(static_cast<std::size_t>(of.handle));
    const auto at = static_cast<std::size_t>(of.motion);
    const double before = at > 0 && isLeft(of.motion - 1) ? own.motions.at(at - 1).end : 0;
    const bool follows = at + 1 < own.motions.size() && isLeft(of.motion + 1);
    return {std::max(before, own.activeFrom), follows ? own.motions[at + 1].start : own.activeTo};
}

/// Returns the possible end nearest to the wanted one if the other end of the span stays.
double scaledEnd(const Design& design, const std::vector<MotionId>& motions, double stays, double end,
                 double wanted) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double low = -kInfinity, high = kInfinity, shortest = kInfinity;
    for (const MotionId& id : motions) {
        const MotionTime time = timeOf(design, id.handle, id.motion), room = roomOf(design, id, motions);
        // Returns the end of the span that puts this time of the motion at its limit.
        const auto endFor = [&](double own, double limit) {
            return std::lerp(stays, limit, (end - stays) / (own - stays));
        };
        if (time.start != stays) low = std::max(low, endFor(time.start, room.start));
        if (time.end != stays) high = std::min(high, endFor(time.end, room.end));
        shortest = std::min(shortest, time.end - time.start);
    }
    const double least = stays + (end - stays) * kShortestMotion / shortest;
    return std::min(std::max(end > stays ? std::max(wanted, least) : std::min(wanted, least), low), high);
}

}  // namespace

MotionTime timeOf(const Design& design, int handle, int motion) {
    const PinMotion& own =
        design.handles.at(static_cast<std::size_t>(handle)).motions.at(static_cast<std::size_t>(motion));
    return {own.start, own.end};
}

MotionTime spanOf(const Design& design, const std::vector<MotionId>& motions) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    MotionTime span{kInfinity, -kInfinity};
    for (const auto& [handle, motion] : motions) {
        const MotionTime own = timeOf(design, handle, motion);
        span = {std::min(span.start, own.start), std::max(span.end, own.end)};
    }
    return span;
}

double carried(double time, const MotionTime& from, const MotionTime& to) {
    return std::lerp(to.start, to.end, (time - from.start) / (from.end - from.start));
}

MotionTime fittedSpan(const Design& design, const std::vector<MotionId>& motions, const MotionTime& wanted) {
    const auto [start, end] = spanOf(design, motions);
    if (wanted.start == start) return {start, scaledEnd(design, motions, start, end, wanted.end)};
    if (wanted.end == end) return {scaledEnd(design, motions, end, start, wanted.start), end};
    double moved = wanted.start;
    for (const MotionId& id : motions) {
        const MotionTime time = timeOf(design, id.handle, id.motion), room = roomOf(design, id, motions);
        moved = std::clamp(moved, start + (room.start - time.start), start + (room.end - time.end));
    }
    return {moved, moved + (end - start)};
}

Project withMotionSpan(const Project& project, const std::vector<MotionId>& motions,
                       const MotionTime& wanted) {
    const MotionTime from = spanOf(project.design, motions), to = fittedSpan(project.design, motions, wanted);
    Project result = project;
    for (const MotionId& id : motions) {
        const MotionTime time = timeOf(project.design, id.handle, id.motion),
                         room = roomOf(project.design, id, motions);
        // Rounded, they may not overlap either.
        const double start = std::max(carried(time.start, from, to), room.start),
                     end = std::min(carried(time.end, from, to), room.end);
        result.design = edited(std::move(result.design), id.handle, [&](auto& own) {
            own.at(static_cast<std::size_t>(id.motion)).start = start;
            own.at(static_cast<std::size_t>(id.motion)).end = end;
        });
        result.end = std::max(result.end, end);
    }
    return result;
}

Design withMotionEase(const Design& design, const std::vector<MotionId>& motions, Ease ease) {
    Design result = design;
    for (const MotionId& id : motions)
        result = edited(std::move(result), id.handle,
                        [&](auto& own) { setEase(own.at(static_cast<std::size_t>(id.motion)), ease); });
    return result;
}

MotionTime holdOf(const Design& design, int handle) {
    const Pin& own = design.handles.at(static_cast<std::size_t>(handle));
    return {own.activeFrom, own.activeTo};
}

Design withHold(const Design& design, int handle, const MotionTime& hold, double filmEnd) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Design result = design;
    Pin& own = result.handles.at(static_cast<std::size_t>(handle));
    own.activeFrom = hold.start;
    own.activeTo = std::max(hold.end, hold.start + kShortestMotion);
    if (!own.motions.empty()) {
        own.activeFrom = std::min(own.activeFrom, own.motions.front().start);
        own.activeTo = std::max(own.activeTo, own.motions.back().end);
    }
    if (own.activeFrom <= 0) own.activeFrom = -kInfinity;
    if (own.activeTo >= filmEnd) own.activeTo = kInfinity;
    return result;
}

Design withoutMotions(const Design& design, std::vector<MotionId> motions) {
    Design result = design;
    std::ranges::sort(motions, std::greater());  // the later ones first: the others keep their places
    for (const MotionId& id : motions)
        result = edited(std::move(result), id.handle, [&](auto& own) { own.erase(own.begin() + id.motion); });
    return result;
}

}  // namespace wend
