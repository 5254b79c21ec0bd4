#include "app/document/timing_edits.h"
#include "app/document/project.h"

#include <algorithm>
#include <limits>

namespace wend {

namespace {

/// Calls `edit` with the motions of a handle, of whatever dimension.
template <class Edit>
AnyDesign edited(AnyDesign design, int handle, const Edit& edit) {
    std::visit([&](auto& own) { edit(own.handles.at(static_cast<std::size_t>(handle)).motions); }, design);
    return design;
}

/// The same length where there is room for it, moved as little as possible.
MotionTime within(const MotionTime& room, MotionTime time) {
    const double length = std::min(std::max(time.end - time.start, kShortestMotion), room.end - room.start);
    time.start = std::clamp(time.start, room.start, room.end - length);
    return {time.start, std::min(time.start + length, room.end)};
}

}  // namespace

MotionTime timeOf(const AnyDesign& design, int handle, int motion) {
    return std::visit(
        [=](const auto& one) -> MotionTime {
            const auto& own =
                one.handles.at(static_cast<std::size_t>(handle)).motions.at(static_cast<std::size_t>(motion));
            return {own.start, own.end};
        },
        design);
}

MotionTime roomOf(const AnyDesign& design, int handle, int motion) {
    return std::visit(
        [=](const auto& one) -> MotionTime {
            const auto& own = one.handles.at(static_cast<std::size_t>(handle));
            const auto at = static_cast<std::size_t>(motion);
            const double before = at > 0 ? own.motions.at(at - 1).end : 0;
            const double after = at + 1 < own.motions.size() ? own.motions[at + 1].start : own.activeTo;
            return {std::max(before, own.activeFrom), after};
        },
        design);
}

Project withMotionTime(const Project& project, int handle, int motion, const MotionTime& time) {
    const MotionTime next = within(roomOf(project.design, handle, motion), time);
    Project result = project;
    result.design = edited(project.design, handle, [&](auto& motions) {
        motions.at(static_cast<std::size_t>(motion)).start = next.start;
        motions.at(static_cast<std::size_t>(motion)).end = next.end;
    });
    result.end = std::max(result.end, next.end);
    return result;
}

AnyDesign withMotionEase(const AnyDesign& design, int handle, int motion, Ease ease) {
    return edited(design, handle,
                  [=](auto& motions) { motions.at(static_cast<std::size_t>(motion)).ease = ease; });
}

MotionTime holdOf(const AnyDesign& design, int handle) {
    return std::visit(
        [=](const auto& one) -> MotionTime {
            const auto& own = one.handles.at(static_cast<std::size_t>(handle));
            return {own.activeFrom, own.activeTo};
        },
        design);
}

AnyDesign withHold(const AnyDesign& design, int handle, const MotionTime& hold, double filmEnd) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    AnyDesign result = design;
    std::visit(
        [&](auto& one) {
            auto& own = one.handles.at(static_cast<std::size_t>(handle));
            own.activeFrom = hold.start;
            own.activeTo = std::max(hold.end, hold.start + kShortestMotion);
            if (!own.motions.empty()) {
                own.activeFrom = std::min(own.activeFrom, own.motions.front().start);
                own.activeTo = std::max(own.activeTo, own.motions.back().end);
            }
            if (own.activeFrom <= 0) own.activeFrom = -kInfinity;
            if (own.activeTo >= filmEnd) own.activeTo = kInfinity;
        },
        result);
    return result;
}

AnyDesign withoutMotion(const AnyDesign& design, int handle, int motion) {
    return edited(design, handle, [=](auto& motions) { motions.erase(motions.begin() + motion); });
}

}  // namespace wend
