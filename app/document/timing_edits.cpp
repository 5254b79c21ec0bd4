#include "app/document/timing_edits.h"
#include "app/document/project.h"

#include <algorithm>
#include <limits>

namespace wend {

namespace {

/// Calls `edit` with the motions of a handle, of whatever dimension.
template <class Edit>
Project edited(Project project, int handle, const Edit& edit) {
    std::visit([&](auto& design) { edit(design.handles.at(static_cast<std::size_t>(handle)).motions); },
               project.design);
    return project;
}

/// The same length where there is room for it, moved as little as possible.
MotionTime within(const MotionTime& room, MotionTime time) {
    const double length = std::min(std::max(time.end - time.start, kShortestMotion), room.end - room.start);
    time.start = std::clamp(time.start, room.start, room.end - length);
    return {time.start, std::min(time.start + length, room.end)};
}

}  // namespace

MotionTime timeOf(const Project& project, int handle, int motion) {
    return std::visit(
        [=](const auto& design) -> MotionTime {
            const auto& own = design.handles.at(static_cast<std::size_t>(handle))
                                  .motions.at(static_cast<std::size_t>(motion));
            return {own.start, own.end};
        },
        project.design);
}

MotionTime roomOf(const Project& project, int handle, int motion) {
    return std::visit(
        [=](const auto& design) -> MotionTime {
            const auto& own = design.handles.at(static_cast<std::size_t>(handle));
            const auto at = static_cast<std::size_t>(motion);
            const double before = at > 0 ? own.motions.at(at - 1).end : 0;
            const double after = at + 1 < own.motions.size() ? own.motions[at + 1].start : own.activeTo;
            return {std::max(before, own.activeFrom), after};
        },
        project.design);
}

Project withMotionTime(const Project& project, int handle, int motion, const MotionTime& time) {
    const MotionTime next = within(roomOf(project, handle, motion), time);
    Project result = edited(project, handle, [&](auto& motions) {
        motions.at(static_cast<std::size_t>(motion)).start = next.start;
        motions.at(static_cast<std::size_t>(motion)).end = next.end;
    });
    result.end = std::max(result.end, next.end);
    return result;
}

Project withMotionEase(const Project& project, int handle, int motion, Ease ease) {
    return edited(project, handle,
                  [=](auto& motions) { motions.at(static_cast<std::size_t>(motion)).ease = ease; });
}

MotionTime holdOf(const Project& project, int handle) {
    return std::visit(
        [=](const auto& design) -> MotionTime {
            const auto& own = design.handles.at(static_cast<std::size_t>(handle));
            return {own.activeFrom, own.activeTo};
        },
        project.design);
}

Project withHold(const Project& project, int handle, const MotionTime& hold) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Project result = project;
    std::visit(
        [&](auto& design) {
            auto& own = design.handles.at(static_cast<std::size_t>(handle));
            own.activeFrom = hold.start;
            own.activeTo = std::max(hold.end, hold.start + kShortestMotion);
            if (!own.motions.empty()) {
                own.activeFrom = std::min(own.activeFrom, own.motions.front().start);
                own.activeTo = std::max(own.activeTo, own.motions.back().end);
            }
            if (own.activeFrom <= 0) own.activeFrom = -kInfinity;
            if (own.activeTo >= project.end) own.activeTo = kInfinity;
        },
        result.design);
    return result;
}

Project withoutMotion(const Project& project, int handle, int motion) {
    return edited(project, handle, [=](auto& motions) { motions.erase(motions.begin() + motion); });
}

}  // namespace wend
