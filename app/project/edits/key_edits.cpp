#include "app/project/edits/key_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "app/project/design.h"
#include "app/project/edits/grown_path.h"
#include "app/project/edits/offset_path.h"
#include "app/project/edits/pose_edits.h"
#include "app/project/edits/progress.h"
#include "app/project/edits/rigid_path.h"
#include "app/project/project.h"
#include "core/motion/constraints.h"
#include "core/motion/easing.h"

namespace wend {

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

std::vector<double> timesOf(const Pin& handle) {
    std::set<double> times;
    for (const PinMotion& motion : handle.motions) times.insert({motion.start, motion.end});
    return {times.begin(), times.end()};
}

/// The motions before and after a key, of which one may be missing.
struct Sides {
    typename std::vector<PinMotion>::iterator before, after;
    Sides(std::vector<PinMotion>& motions, double time)
        : before(std::ranges::find(motions, time, &PinMotion::end)),
          after(std::ranges::find(motions, time, &PinMotion::start)) {}
};

/// Calls `edit` with the handle of each key and its time, in the order of the keys.
template <class Edit>
Design edited(Design design, const std::vector<KeyId>& keys, const Edit& edit) {
    for (const KeyId& key : keys) edit(design.handles.at(static_cast<std::size_t>(key.handle)), key.time);
    return design;
}

Ease easeWith(bool start, bool end) {
    return start ? (end ? Ease::InOut : Ease::In) : (end ? Ease::Out : Ease::Linear);
}

/// Returns the times of the handle's nearest keys that do not move along, or the limits of its time.
MotionTime roomOf(const Design& design, const KeyId& key, const std::vector<KeyId>& along) {
    const Pin& own = design.handles.at(static_cast<std::size_t>(key.handle));
    MotionTime room{std::max(0.0, own.activeFrom), own.activeTo};
    for (const double time : timesOf(own)) {
        if (isAmong(along, KeyId{key.handle, time})) continue;
        if (time < key.time) room.start = std::max(room.start, time);
        if (time > key.time) room.end = std::min(room.end, time);
    }
    return room;
}

/// Returns how near a key may come to the limits of its room: a motion has a duration, a hold may vanish.
MotionTime gapsOf(const Design& design, const KeyId& key, const MotionTime& room) {
    MotionTime gaps{0, 0};
    for (const PinMotion& motion : design.handles.at(static_cast<std::size_t>(key.handle)).motions) {
        const double shortest = std::min(kShortestMotion, motion.end - motion.start);
        if (motion.start == room.start) gaps.start = shortest;
        if (motion.end == room.end) gaps.end = shortest;
    }
    return gaps;
}

/// Returns the key after another one of a handle; infinity if that is the last.
double keyAfter(const Pin& handle, double time) {
    const auto times = timesOf(handle);
    const auto next = std::ranges::upper_bound(times, time);
    return next == times.end() ? kForever : *next;
}

void removeKey(Pin& handle, double time) {
    auto& motions = handle.motions;
    const Sides sides(motions, time);
    if (sides.before != motions.end() && sides.after != motions.end()) {
        const auto offset = offsetOf(*sides.before), on = offsetOf(*sides.after);
        auto whole = offset && on ? std::nullopt : joinedRotations(*sides.before, *sides.after);
        if (!whole && !(offset && on)) whole = joinedGrowth(*sides.before, *sides.after);
        if (!whole && !(offset && on)) return;
        const Ease ease = easeWith(slowSidesOf(*sides.before).start, slowSidesOf(*sides.after).end);
        if (whole)
            sides.before->kind = whole->kind;
        else
            sides.before->kind = Translate<3>{*offset + *on};
        sides.before->ease = ease;
        sides.before->end = sides.after->end;
        motions.erase(sides.after);
    } else if (sides.before != motions.end()) {
        if (const double next = keyAfter(handle, time); next < kForever)
            sides.before->end = next;
        else
            motions.erase(sides.before);
    } else if (sides.after != motions.end()) {
        sides.after->start =
            sides.after == motions.begin() ? std::max(0.0, handle.activeFrom) : std::prev(sides.after)->end;
    }
}

void holdKey(Pin& handle, double time) {
    auto& motions = handle.motions;
    const auto held = Sides(motions, time).after;
    if (held == motions.end()) return;
    const auto offset = offsetOf(*held);
    const auto next = held + 1;
    if (!offset) return;
    if (next == motions.end()) {
        motions.erase(held);
    } else if (next->start > held->end) {
        *held = {Translate<3>{*offset}, held->end, next->start};
    } else if (const auto on = led(*next, -*offset, 1, 0, Vec3::Zero())) {
        *next = *on;
        motions.erase(held);
    }
}

/// Returns the place at a time of a handle's point that starts at `start`.
Vec3 placeAt(const Pin& handle, double time, const Vec3& start) {
    return HandleTimeline<3>(handleIn<3>(handle)).bodyAt(time, Side::Before).position(start);
}

void easeKey(Pin& handle, double time, const KeyEase& ease) {
    const Sides sides(handle.motions, time);
    const auto none = handle.motions.end();
    if (sides.before != none) setSlowSides(*sides.before, {slowSidesOf(*sides.before).start, ease.before});
    if (sides.after != none) setSlowSides(*sides.after, {ease.after, slowSidesOf(*sides.after).end});
}

/// Eases straight motions beside a new key; others have the rhythm that they had.
void easeStraight(Pin& handle, double time, const KeyEase& ease) {
    const Sides sides(handle.motions, time);
    for (const auto& [side, before] : {std::pair{sides.before, true}, {sides.after, false}}) {
        if (side == handle.motions.end() || !std::holds_alternative<Translate<3>>(side->kind)) continue;
        const SlowSides now = slowSidesOf(*side);
        setSlowSides(*side, before ? SlowSides{now.start, ease.before} : SlowSides{ease.after, now.end});
    }
}

/// Returns the key of a handle that poseAt() set at a time: the end of a motion if one is near, otherwise the
/// nearest key.
double nearestKey(const Pin& handle, double time) {
    const auto off = [time](const PinMotion& motion) { return std::abs(motion.end - time); };
    const auto before = std::ranges::min_element(handle.motions, {}, off);
    if (before != handle.motions.end() && off(*before) < kShortestMotion) return before->end;
    const auto times = timesOf(handle);
    return *std::ranges::min_element(times, {}, [time](double t) { return std::abs(t - time); });
}

constexpr std::array kFits = {Ease::Linear, Ease::InOut, Ease::In, Ease::Out};

/// Returns whether a straight motion is near a part of a path at its samples, between which both are smooth.
bool fits(const OffsetPath& path, std::size_t from, std::size_t to, Ease kind, double tolerance) {
    const Vec3& start = path.offsets[from];
    const Vec3 by = path.offsets[to] - start;
    for (std::size_t i = from + 1; i < to; ++i) {
        const double s = (path.times[i] - path.times[from]) / (path.times[to] - path.times[from]);
        if ((start + ease(kind, s) * by - path.offsets[i]).norm() > tolerance) return false;
    }
    return true;
}

/// Returns the straight motions along a path, each as long as possible.
std::vector<PinMotion> straightParts(const OffsetPath& path, double tolerance) {
    std::vector<PinMotion> parts;
    const std::size_t last = path.times.size() - 1;
    for (std::size_t from = 0, to = last; from < last; from = to, to = last) {
        auto kind = kFits.end();
        const auto find = [&] {
            kind =
                std::ranges::find_if(kFits, [&](Ease one) { return fits(path, from, to, one, tolerance); });
            return kind != kFits.end();
        };
        while (!find()) --to;
        parts.push_back(
            {Translate<3>{path.offsets[to] - path.offsets[from]}, path.times[from], path.times[to], *kind});
    }
    return parts;
}

/// Returns the path with samples that are close enough for the easing between them.
OffsetPath refined(const OffsetPath& path) {
    constexpr int kLeast = 64;
    const double step = (path.times.back() - path.times.front()) / kLeast;
    OffsetPath fine;
    for (std::size_t i = 0; i + 1 < path.times.size(); ++i) {
        const int parts = 1 + static_cast<int>((path.times[i + 1] - path.times[i]) / step);
        for (int k = 0; k < parts; ++k) {
            fine.times.push_back(std::lerp(path.times[i], path.times[i + 1], double(k) / parts));
            fine.offsets.push_back(k == 0 ? path.offsets[i] : path.at(fine.times.back()));
        }
    }
    fine.times.push_back(path.times.back());
    fine.offsets.push_back(path.offsets.back());
    return fine;
}

void divide(std::vector<PinMotion>& motions, int at, double tolerance) {
    const PinMotion& own = motions.at(static_cast<std::size_t>(at));
    if (std::holds_alternative<Translate<3>>(own.kind)) return;
    const auto path = offsetPathOf(own, own.end);
    if (!path) return;
    std::vector<PinMotion> parts = straightParts(refined(*path), tolerance);
    parts.front().start = own.start;
    parts.back().end = own.end;
    motions.erase(motions.begin() + at);
    motions.insert(motions.begin() + at, parts.begin(), parts.end());
}

template <class Edit>
Design edited(Design design, const std::vector<MotionId>& motions, const Edit& edit) {
    for (const MotionId& id : motions)
        edit(design.handles.at(static_cast<std::size_t>(id.handle)).motions, id.motion);
    return design;
}

void straighten(std::vector<PinMotion>& motions, int at) {
    PinMotion& own = motions.at(static_cast<std::size_t>(at));
    if (const auto offset = offsetOf(own)) own.kind = Translate<3>{*offset};
}

}  // namespace

std::vector<double> keyTimes(const Design& design, int handle) {
    return timesOf(design.handles.at(static_cast<std::size_t>(handle)));
}

double fittedShift(const Design& design, const std::vector<KeyId>& keys, double wanted) {
    double low = -kForever, high = kForever;
    for (const KeyId& key : keys) {
        const MotionTime room = roomOf(design, key, keys), gaps = gapsOf(design, key, room);
        low = std::max(low, std::min(0.0, room.start + gaps.start - key.time));
        high = std::min(high, std::max(0.0, room.end - gaps.end - key.time));
    }
    return std::clamp(wanted, low, high);
}

std::shared_ptr<const Project> withKeysMoved(const Project& project, const std::vector<KeyId>& keys,
                                             double by) {
    const double shift = fittedShift(project.design, keys, by);
    auto result = copyOf(project);
    if (shift == 0) return result;
    for (const KeyId& key : keys) {
        const MotionTime room = roomOf(project.design, key, keys);
        // Rounded, it may not go beyond its neighbours either.
        const double time = std::clamp(key.time + shift, room.start, room.end);
        const auto at = static_cast<std::size_t>(key.handle);
        const auto& before = project.design.handles.at(at).motions;
        for (std::size_t i = 0; i < before.size(); ++i) {
            PinMotion& motion = result->design.handles[at].motions[i];
            if (before[i].start == key.time) motion.start = time;
            if (before[i].end == key.time) motion.end = time;
        }
        result->end = std::max(result->end, time);
    }
    return result;
}

Design withoutKeys(const Design& design, std::vector<KeyId> keys) {
    std::ranges::sort(keys, std::greater());
    return edited(design, keys, [](auto& handle, double time) { removeKey(handle, time); });
}

Design withKeysHeld(const Design& design, std::vector<KeyId> keys) {
    std::ranges::sort(keys);
    return edited(design, keys, [](auto& handle, double time) { holdKey(handle, time); });
}

KeyEase easeAt(const Design& design, const KeyId& key) {
    KeyEase ease;
    for (const PinMotion& motion : design.handles.at(static_cast<std::size_t>(key.handle)).motions) {
        if (motion.end == key.time) ease.before = slowSidesOf(motion).end;
        if (motion.start == key.time) ease.after = slowSidesOf(motion).start;
    }
    return ease;
}

Design withKeyEase(const Design& design, const std::vector<KeyId>& keys, const KeyEase& ease) {
    return edited(design, keys, [&](auto& handle, double time) { easeKey(handle, time, ease); });
}

std::vector<CopiedKey> copiedKeys(const Design& design, const std::vector<KeyId>& keys,
                                  const std::vector<Vec3>& starts) {
    std::vector<CopiedKey> copies;
    double first = kForever;
    for (const KeyId& key : keys) {
        const auto at = static_cast<std::size_t>(key.handle);
        const Vec3 offset = placeAt(design.handles.at(at), key.time, starts.at(at)) - starts[at];
        copies.push_back({key.handle, key.time, offset, easeAt(design, key)});
        first = std::min(first, key.time);
    }
    for (CopiedKey& copy : copies) copy.after -= first;
    std::ranges::stable_sort(copies, {}, &CopiedKey::after);
    return copies;
}

std::shared_ptr<const Project> withKeysPasted(const Project& project, const std::vector<CopiedKey>& copies,
                                              double time, const std::vector<Vec3>& starts,
                                              std::vector<KeyId>& pasted) {
    auto next = copyOf(project);
    pasted.clear();
    for (const CopiedKey& copy : copies) {
        const auto at = static_cast<std::size_t>(copy.handle);
        auto& handle = next->design.handles.at(at);
        const double when = time + copy.after;
        if (when > handle.activeTo) continue;
        const Vec3 now = placeAt(handle, when, starts.at(at));
        const Vec3 by = starts[at] + copy.offset.head<3>() - now;
        if (!poseAt(handle, now, by, when)) continue;
        const double key = nearestKey(handle, when);
        easeStraight(handle, key, copy.ease);
        pasted.push_back({copy.handle, key});
        next->end = std::max(next->end, key);
    }
    return next;
}

Design straightened(const Design& design, const std::vector<MotionId>& motions) {
    return edited(design, motions, [](auto& own, int at) { straighten(own, at); });
}

Design withFewKeys(const Design& design, std::vector<MotionId> motions, double tolerance) {
    std::ranges::sort(motions, std::greater());  // the later ones first: the others keep their places
    return edited(design, motions, [=](auto& own, int at) { divide(own, at, tolerance); });
}

}  // namespace wend
