#include "app/document/edits/pose_edits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/document/edits/bezier_edits.h"
#include "app/document/edits/offset_path.h"
#include "app/document/edits/progress.h"
#include "app/document/edits/timing_edits.h"
#include "app/document/project.h"

namespace wend {

namespace {

/// Returns both parts of a cubic of the time, led through a pose: exactly, because the displacement times a
/// factor that is linear in time is a cubic, too.
template <int Dim>
std::array<Motion<Dim>, 2> splitCubic(const Motion<Dim>& motion, std::array<Vec<Dim>, 4> points,
                                      const Vec<Dim>& place, const Vec<Dim>& by, double time) {
    const double s = (time - motion.start) / (motion.end - motion.start);
    const std::vector<Vec<Dim>> both = splitBezier<Dim>({points.begin(), points.end()}, 0, s);
    std::array<Vec<Dim>, 4> first, second;
    for (std::size_t k = 0; k < 4; ++k) {
        const double share = static_cast<double>(k) / 3;
        first[k] = place + (both[k] - both[3]) + share * by;
        second[k] = place + (both[3 + k] - both[3]) + (1 - share) * by;
    }
    return {cubicMove<Dim>(first, {motion.start, time}), cubicMove<Dim>(second, {time, motion.end})};
}

/// Leads the motion that contains the time through a pose, as two motions.
template <int Dim>
bool splitThrough(std::vector<Motion<Dim>>& motions, std::size_t i, const Vec<Dim>& place, const Vec<Dim>& by,
                  double time) {
    const bool isEven =
        motions[i].ease == Ease::Linear && std::holds_alternative<Translate<Dim>>(motions[i].kind);
    if (const auto cubic = isEven ? std::nullopt : cubicOf<Dim>(motions[i])) {
        const auto [before, after] = splitCubic<Dim>(motions[i], *cubic, place, by, time);
        motions[i] = before;
        motions.insert(motions.begin() + static_cast<std::ptrdiff_t>(i) + 1, after);
        return true;
    }
    const auto path = offsetPathOf<Dim>(motions[i], time);
    if (!path) return false;
    const auto [before, after] = split<Dim>(*path, time);
    const Vec<Dim> start = place - path->at(time);
    motions[i] = motionAlong<Dim>(before.led(by, 0, 1), start);
    motions.insert(motions.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   motionAlong<Dim>(after.led(by, 1, 0), place + by));
    return true;
}

}  // namespace

template <int Dim>
bool poseAt(Handle<Dim>& handle, const Vec<Dim>& place, const Vec<Dim>& by, double time) {
    auto& motions = handle.motions;
    const auto isNear = [&](double t) { return std::abs(t - time) < kShortestMotion; };
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const Motion<Dim>& own = motions[i];
        if (own.start < time && time < own.end && !isNear(own.start) && !isNear(own.end))
            return splitThrough<Dim>(motions, i, place, by, time);
    }
    // At a key pose, or while the handle holds still.
    auto previous = motions.end();  // the one that ends nearest
    for (auto one = motions.begin(); one != motions.end(); ++one)
        if (isNear(one->end) &&
            (previous == motions.end() || std::abs(one->end - time) < std::abs(previous->end - time)))
            previous = one;
    const auto next = std::find_if(previous == motions.end() ? motions.begin() : previous + 1, motions.end(),
                                   [&](const auto& one) { return one.start >= time || isNear(one.start); });
    std::vector<Motion<Dim>> result(motions.begin(), previous == motions.end() ? next : previous);
    double key = time;
    if (previous != motions.end()) {
        const auto offset = offsetOf<Dim>(*previous);
        if (!offset) return false;
        key = previous->end;
        result.push_back(*led<Dim>(*previous, by, 0, 1, place - *offset));
    } else {
        const double from =
            std::max(result.empty() ? 0 : result.back().end, std::max(handle.activeFrom, 0.0));
        if (next != motions.end() && isNear(next->start)) key = next->start;
        if (key - from < kShortestMotion) return false;
        result.push_back({Translate<Dim>{by}, from, key});
    }
    if (next != motions.end()) {
        const bool follows = next->start - key < kShortestMotion;
        const auto path = follows ? led<Dim>(*next, by, 1, 0, place + by)
                                  : Motion<Dim>{Translate<Dim>{-by}, key, next->start};
        if (!path) return false;
        result.push_back(*path);
        result.insert(result.end(), follows ? next + 1 : next, motions.end());
    }
    motions = std::move(result);
    return true;
}

template <int Dim>
std::optional<Project> withPose(const Project& project, const Gesture& gesture,
                                const std::vector<Vec<Dim>>& starts) {
    if (gesture.grip.kind != Grip::Kind::Move) return {};
    Project next = project;
    const Vec<Dim> by = gesture.path.back().template head<Dim>();
    for (std::size_t i = 0; i < gesture.handles.size(); ++i) {
        auto& handle =
            std::get<Design<Dim>>(next.design).handles.at(static_cast<std::size_t>(gesture.handles[i]));
        if (!poseAt<Dim>(handle, starts[i], by, gesture.from)) return {};
    }
    return next;
}

template <int Dim>
Project withPoseAppended(const Project& project, const Gesture& gesture, const std::vector<Vec<Dim>>& starts,
                         double length) {
    Gesture added = gesture;
    added.from = project.end;
    added.times.clear();
    double whole = 0;
    for (std::size_t i = 1; i < gesture.path.size(); ++i)
        whole += (gesture.path[i] - gesture.path[i - 1]).norm();
    double covered = 0;
    for (std::size_t i = 0; i < gesture.path.size(); ++i) {
        if (i > 0) covered += (gesture.path[i] - gesture.path[i - 1]).norm();
        added.times.push_back(whole > 0 ? length * covered / whole : 0);
    }
    added.times.back() = length;
    return withGesture<Dim>(project, added, starts);
}

template <int Dim>
std::optional<Project> withLastMoveCorrected(const Project& project, const Gesture& gesture) {
    if (gesture.grip.kind != Grip::Kind::Move) return {};
    Project next = project;
    for (const int h : gesture.handles) {
        auto& motions = std::get<Design<Dim>>(next.design).handles.at(static_cast<std::size_t>(h)).motions;
        const auto offset = motions.empty() ? std::nullopt : offsetOf<Dim>(motions.back());
        if (!offset || motions.back().end != project.end) return {};
        motions.back().kind = Translate<Dim>{*offset + gesture.path.back().template head<Dim>()};
    }
    return next;
}

#define WEND_INSTANTIATE(Dim)                                                                            \
    template bool poseAt<Dim>(Handle<Dim>&, const Vec<Dim>&, const Vec<Dim>&, double);                   \
    template std::optional<Project> withPose<Dim>(const Project&, const Gesture&,                        \
                                                  const std::vector<Vec<Dim>>&);                         \
    template Project withPoseAppended<Dim>(const Project&, const Gesture&, const std::vector<Vec<Dim>>&, \
                                           double);                                                      \
    template std::optional<Project> withLastMoveCorrected<Dim>(const Project&, const Gesture&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
