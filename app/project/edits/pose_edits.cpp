#include "app/project/edits/pose_edits.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "app/project/edits/bezier_edits.h"
#include "app/project/edits/grown_path.h"
#include "app/project/edits/offset_path.h"
#include "app/project/edits/progress.h"
#include "app/project/edits/rigid_path.h"
#include "app/project/edits/timing_edits.h"
#include "app/project/project.h"

namespace wend {

namespace {

/// Leads a path that is a cubic of the time, piece by piece, through a pose: exactly, because the
/// displacement times a factor that is linear in time is a cubic, too. Returns the number of pieces before
/// the pose.
std::size_t splitCubics(std::vector<TimedCubic>& pieces, const Vec3& place, const Vec3& by, double time) {
    const auto at = std::ranges::find_if(pieces, [time](const auto& piece) { return time < piece.time.end; });
    const auto before = static_cast<std::size_t>(at - pieces.begin()) + 1;
    const MotionTime own = at->time;
    const std::vector<Vec3> both =
        splitBezier({at->points.begin(), at->points.end()}, 0, (time - own.start) / (own.end - own.start));
    *at = {{both[0], both[1], both[2], both[3]}, {own.start, time}};
    pieces.insert(at + 1, {{both[3], both[4], both[5], both[6]}, {time, own.end}});
    const double start = pieces.front().time.start, end = pieces.back().time.end;
    for (TimedCubic& piece : pieces)
        for (std::size_t k = 0; k < 4; ++k) {
            const double t = std::lerp(piece.time.start, piece.time.end, static_cast<double>(k) / 3);
            const double factor = t <= time ? (t - start) / (time - start) : (end - t) / (end - time);
            piece.points[k] += place - both[3] + factor * by;
        }
    return before;
}

/// Returns whether a pose at a time leaves none of the pieces too short.
bool hasRoom(const std::vector<TimedCubic>& pieces, double time) {
    return !pieces.empty() && std::ranges::all_of(pieces, [time](const TimedCubic& piece) {
        return std::abs(piece.time.start - time) >= kShortestMotion &&
               std::abs(piece.time.end - time) >= kShortestMotion;
    });
}

/// Adds motions along pieces. Those of a chain, which take equal times, stay one.
void addPieces(std::vector<PinMotion>& motions, std::span<const TimedCubic> pieces, bool isChain) {
    if (!isChain || pieces.size() < 2) {
        for (const TimedCubic& piece : pieces) motions.push_back(cubicMove(piece.points, piece.time));
        return;
    }
    CurveMotion<3> chain;
    chain.points = {pieces.front().points.front()};
    for (const TimedCubic& piece : pieces)
        chain.points.insert(chain.points.end(), piece.points.begin() + 1, piece.points.end());
    motions.push_back({std::move(chain), pieces.front().time.start, pieces.back().time.end});
}

/// Returns a path of cubics that is led through a pose. A chain is divided at the ends of its piece around
/// the time, a spline at each of its points, where its pieces take unequal times.
std::vector<PinMotion> ledCubics(const PinMotion& motion, std::vector<TimedCubic> pieces, const Vec3& place,
                                 const Vec3& by, double time) {
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    const bool isChain = curve && curve->interpolation == Interpolation::Bezier;
    const std::size_t before = splitCubics(pieces, place, by, time);
    const std::span<const TimedCubic> all(pieces);
    std::vector<PinMotion> result;
    addPieces(result, all.first(before - 1), isChain);
    addPieces(result, all.subspan(before - 1, 2), false);
    addPieces(result, all.subspan(before + 1), isChain);
    return result;
}

/// Leads a motion that rotates, grows or deforms its handle, too, through a pose: an even rotation as two
/// rotations about other centres, growth and fields exactly, others as two tables of poses.
bool splitOther(std::vector<PinMotion>& motions, std::size_t i, const Vec3& place, const Vec3& by,
                double time) {
    const PinMotion own = motions[i];
    auto parts = ledWhileGrowing(own, by, time);
    if (parts.empty()) parts = ledRotation(own, by, time);
    if (!parts.empty()) {
        const auto at = motions.erase(motions.begin() + static_cast<std::ptrdiff_t>(i));
        motions.insert(at, parts.begin(), parts.end());
        return true;
    }
    const auto start = startOfRigid(own, time, place);
    if (!start) return false;
    const auto before = ledRigidly(own, {own.start, time}, *start, by, 0, 1);
    const auto after = ledRigidly(own, {time, own.end}, *start, by, 1, 0);
    if (!before || !after) return false;
    motions[i] = *before;
    motions.insert(motions.begin() + static_cast<std::ptrdiff_t>(i) + 1, *after);
    return true;
}

/// Returns the motion that ends at a pose, led there; nothing if it cannot be.
std::optional<PinMotion> ledTo(const PinMotion& motion, const Vec3& place, const Vec3& by) {
    if (const auto offset = offsetOf(motion)) return led(motion, by, 0, 1, place - *offset);
    if (auto grown = ledGrowth(motion, by, 0, 1); !grown.empty()) return grown.front();
    if (auto turned = turnedTo(motion, Vec3::Zero(), by)) return turned;
    const auto start = startOfRigid(motion, motion.end, place);
    return start ? ledRigidly(motion, {motion.start, motion.end}, *start, by, 0, 1) : std::nullopt;
}

/// Returns the motion that starts at a pose, led from there; nothing if it cannot be.
std::optional<PinMotion> ledFrom(const PinMotion& motion, const Vec3& place, const Vec3& by) {
    if (const auto on = led(motion, by, 1, 0, place + by)) return on;
    if (auto grown = ledGrowth(motion, by, 1, 0); !grown.empty()) return grown.front();
    if (auto turned = turnedTo(motion, by, Vec3::Zero())) return turned;
    return ledRigidly(motion, {motion.start, motion.end}, place, by, 1, 0);
}

/// Leads the motion that contains the time through a pose, as two motions or more.
bool splitThrough(std::vector<PinMotion>& motions, std::size_t i, const Vec3& place, const Vec3& by,
                  double time) {
    const bool isEven =
        motions[i].ease == Ease::Linear && std::holds_alternative<Translate<3>>(motions[i].kind);
    if (const auto pieces = cubicsOf(motions[i]); !isEven && hasRoom(pieces, time)) {
        const auto parts = ledCubics(motions[i], pieces, place, by, time);
        const auto at = motions.erase(motions.begin() + static_cast<std::ptrdiff_t>(i));
        motions.insert(at, parts.begin(), parts.end());
        return true;
    }
    const auto path = offsetPathOf(motions[i], time);
    if (!path) return splitOther(motions, i, place, by, time);
    const auto [before, after] = split(*path, time);
    const Vec3 start = place - path->at(time);
    motions[i] = motionAlong(before.led(by, 0, 1), start);
    motions.insert(motions.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   motionAlong(after.led(by, 1, 0), place + by));
    return true;
}

}  // namespace

bool poseAt(Pin& handle, const Vec3& place, const Vec3& by, double time) {
    auto& motions = handle.motions;
    const auto isNear = [&](double t) { return std::abs(t - time) < kShortestMotion; };
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const PinMotion& own = motions[i];
        if (own.start < time && time < own.end && !isNear(own.start) && !isNear(own.end))
            return splitThrough(motions, i, place, by, time);
    }
    // At a key pose, or while the handle holds still.
    auto previous = motions.end();  // the one that ends nearest
    for (auto one = motions.begin(); one != motions.end(); ++one)
        if (isNear(one->end) &&
            (previous == motions.end() || std::abs(one->end - time) < std::abs(previous->end - time)))
            previous = one;
    const auto next = std::find_if(previous == motions.end() ? motions.begin() : previous + 1, motions.end(),
                                   [&](const auto& one) { return one.start >= time || isNear(one.start); });
    std::vector<PinMotion> result(motions.begin(), previous == motions.end() ? next : previous);
    double key = time;
    if (previous != motions.end()) {
        const auto before = ledTo(*previous, place, by);
        if (!before) return false;
        key = previous->end;
        result.push_back(*before);
    } else {
        const double from =
            std::max(result.empty() ? 0 : result.back().end, std::max(handle.activeFrom, 0.0));
        if (next != motions.end() && isNear(next->start)) key = next->start;
        if (key - from < kShortestMotion) return false;
        result.push_back({Translate<3>{by}, from, key});
    }
    if (next != motions.end()) {
        const bool follows = next->start - key < kShortestMotion;
        const auto path =
            follows ? ledFrom(*next, place, by) : PinMotion{Translate<3>{-by}, key, next->start};
        if (!path) return false;
        result.push_back(*path);
        result.insert(result.end(), follows ? next + 1 : next, motions.end());
    }
    motions = std::move(result);
    return true;
}

std::optional<Project> withPose(const Project& project, const Gesture& gesture,
                                const std::vector<Vec3>& starts) {
    if (gesture.grip.kind != Grip::Kind::Move) return {};
    Project next = project;
    const Vec3 by = gesture.path.back();
    for (std::size_t i = 0; i < gesture.handles.size(); ++i) {
        auto& handle = next.design.handles.at(static_cast<std::size_t>(gesture.handles[i]));
        if (!poseAt(handle, starts[i], by, gesture.from)) return {};
    }
    return next;
}

Project withPoseAppended(const Project& project, const Gesture& gesture, const std::vector<Vec3>& starts,
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
    return withGesture(project, added, starts);
}

std::optional<Project> withLastMoveCorrected(const Project& project, const Gesture& gesture) {
    if (gesture.grip.kind != Grip::Kind::Move) return {};
    Project next = project;
    for (const int h : gesture.handles) {
        auto& motions = next.design.handles.at(static_cast<std::size_t>(h)).motions;
        const auto offset = motions.empty() ? std::nullopt : offsetOf(motions.back());
        if (!offset || motions.back().end != project.end) return {};
        motions.back().kind = Translate<3>{*offset + gesture.path.back()};
    }
    return next;
}

}  // namespace wend
