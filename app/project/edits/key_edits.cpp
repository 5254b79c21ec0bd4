#include "app/project/edits/key_edits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "app/project/edits/grown_path.h"
#include "app/project/edits/offset_path.h"
#include "app/project/edits/pose_edits.h"
#include "app/project/edits/progress.h"
#include "app/project/edits/rigid_path.h"
#include "app/project/project.h"
#include "core/motion/constraints.h"

namespace wend {

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

template <int Dim>
std::vector<double> timesOf(const Handle<Dim>& handle) {
    std::set<double> times;
    for (const Motion<Dim>& motion : handle.motions) times.insert({motion.start, motion.end});
    return {times.begin(), times.end()};
}

/// The motions before and after a key, of which one may be missing.
template <int Dim>
struct Sides {
    typename std::vector<Motion<Dim>>::iterator before, after;
    Sides(std::vector<Motion<Dim>>& motions, double time)
        : before(std::ranges::find(motions, time, &Motion<Dim>::end)),
          after(std::ranges::find(motions, time, &Motion<Dim>::start)) {}
};

/// Calls `edit` with the handle of each key and its time, in the order of the keys.
template <class Edit>
AnyDesign edited(AnyDesign design, const std::vector<KeyId>& keys, const Edit& edit) {
    std::visit(
        [&](auto& own) {
            for (const KeyId& key : keys)
                edit(own.handles.at(static_cast<std::size_t>(key.handle)), key.time);
        },
        design);
    return design;
}

Ease easeWith(bool start, bool end) {
    return start ? (end ? Ease::InOut : Ease::In) : (end ? Ease::Out : Ease::Linear);
}

/// The nearest keys of the handle that do not move along, or the limits of its time.
MotionTime roomOf(const AnyDesign& design, const KeyId& key, const std::vector<KeyId>& along) {
    return std::visit(
        [&](const auto& one) -> MotionTime {
            const auto& own = one.handles.at(static_cast<std::size_t>(key.handle));
            MotionTime room{std::max(0.0, own.activeFrom), own.activeTo};
            for (const double time : timesOf(own)) {
                if (isAmong(along, KeyId{key.handle, time})) continue;
                if (time < key.time) room.start = std::max(room.start, time);
                if (time > key.time) room.end = std::min(room.end, time);
            }
            return room;
        },
        design);
}

/// Returns how near a key may come to the limits of its room: a motion has a duration, a hold may vanish.
MotionTime gapsOf(const AnyDesign& design, const KeyId& key, const MotionTime& room) {
    return std::visit(
        [&](const auto& one) -> MotionTime {
            MotionTime gaps{0, 0};
            for (const auto& motion : one.handles.at(static_cast<std::size_t>(key.handle)).motions) {
                const double shortest = std::min(kShortestMotion, motion.end - motion.start);
                if (motion.start == room.start) gaps.start = shortest;
                if (motion.end == room.end) gaps.end = shortest;
            }
            return gaps;
        },
        design);
}

/// Returns the key after another one of a handle; infinity if that is the last.
template <int Dim>
double keyAfter(const Handle<Dim>& handle, double time) {
    const auto times = timesOf(handle);
    const auto next = std::ranges::upper_bound(times, time);
    return next == times.end() ? kForever : *next;
}

template <int Dim>
void removeKey(Handle<Dim>& handle, double time) {
    auto& motions = handle.motions;
    const Sides<Dim> sides(motions, time);
    if (sides.before != motions.end() && sides.after != motions.end()) {
        const auto offset = offsetOf<Dim>(*sides.before), on = offsetOf<Dim>(*sides.after);
        auto whole = offset && on ? std::nullopt : joinedRotations<Dim>(*sides.before, *sides.after);
        if (!whole && !(offset && on)) whole = joinedGrowth<Dim>(*sides.before, *sides.after);
        if (!whole && !(offset && on)) return;
        const Ease ease = easeWith(slowSidesOf<Dim>(*sides.before).start, slowSidesOf<Dim>(*sides.after).end);
        if (whole)
            sides.before->kind = whole->kind;
        else
            sides.before->kind = Translate<Dim>{*offset + *on};
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

template <int Dim>
void holdKey(Handle<Dim>& handle, double time) {
    auto& motions = handle.motions;
    const auto held = Sides<Dim>(motions, time).after;
    if (held == motions.end()) return;
    const auto offset = offsetOf<Dim>(*held);
    const auto next = held + 1;
    if (!offset) return;
    if (next == motions.end()) {
        motions.erase(held);
    } else if (next->start > held->end) {
        *held = {Translate<Dim>{*offset}, held->end, next->start};
    } else if (const auto on = led<Dim>(*next, -*offset, 1, 0, Vec<Dim>::Zero())) {
        *next = *on;
        motions.erase(held);
    }
}

/// The place of a handle's point, which begins somewhere.
template <int Dim>
Vec<Dim> placeAt(const Handle<Dim>& handle, double time, const Vec<Dim>& start) {
    return HandleTimeline<Dim>(handle).bodyAt(time, Side::Before).position(start);
}

template <int Dim>
void easeKey(Handle<Dim>& handle, double time, const KeyEase& ease) {
    const Sides<Dim> sides(handle.motions, time);
    const auto none = handle.motions.end();
    if (sides.before != none)
        setSlowSides<Dim>(*sides.before, {slowSidesOf<Dim>(*sides.before).start, ease.before});
    if (sides.after != none)
        setSlowSides<Dim>(*sides.after, {ease.after, slowSidesOf<Dim>(*sides.after).end});
}

/// Eases straight motions beside a new key; others have the rhythm that they had.
template <int Dim>
void easeStraight(Handle<Dim>& handle, double time, const KeyEase& ease) {
    const Sides<Dim> sides(handle.motions, time);
    for (const auto& [side, before] : {std::pair{sides.before, true}, {sides.after, false}}) {
        if (side == handle.motions.end() || !std::holds_alternative<Translate<Dim>>(side->kind)) continue;
        const SlowSides now = slowSidesOf<Dim>(*side);
        setSlowSides<Dim>(*side, before ? SlowSides{now.start, ease.before} : SlowSides{ease.after, now.end});
    }
}

/// Returns the key of a handle that poseAt() set at a time: the end of a motion if one is near, otherwise the
/// nearest key.
template <int Dim>
double nearestKey(const Handle<Dim>& handle, double time) {
    const auto off = [time](const Motion<Dim>& motion) { return std::abs(motion.end - time); };
    const auto before = std::ranges::min_element(handle.motions, {}, off);
    if (before != handle.motions.end() && off(*before) < kShortestMotion) return before->end;
    const auto times = timesOf(handle);
    return *std::ranges::min_element(times, {}, [time](double t) { return std::abs(t - time); });
}

}  // namespace

std::vector<double> keyTimes(const AnyDesign& design, int handle) {
    return std::visit(
        [=](const auto& one) { return timesOf(one.handles.at(static_cast<std::size_t>(handle))); }, design);
}

double fittedShift(const AnyDesign& design, const std::vector<KeyId>& keys, double wanted) {
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
        std::visit(
            [&](auto& design) {
                const auto& before = std::get<std::decay_t<decltype(design)>>(project.design);
                const auto at = static_cast<std::size_t>(key.handle);
                for (std::size_t i = 0; i < before.handles.at(at).motions.size(); ++i) {
                    const auto& old = before.handles[at].motions[i];
                    auto& motion = design.handles[at].motions[i];
                    if (old.start == key.time) motion.start = time;
                    if (old.end == key.time) motion.end = time;
                }
            },
            result->design);
        result->end = std::max(result->end, time);
    }
    return result;
}

AnyDesign withoutKeys(const AnyDesign& design, std::vector<KeyId> keys) {
    std::ranges::sort(keys, std::greater());
    return edited(design, keys, [](auto& handle, double time) { removeKey(handle, time); });
}

AnyDesign withKeysHeld(const AnyDesign& design, std::vector<KeyId> keys) {
    std::ranges::sort(keys);
    return edited(design, keys, [](auto& handle, double time) { holdKey(handle, time); });
}

KeyEase easeAt(const AnyDesign& design, const KeyId& key) {
    KeyEase ease;
    std::visit(
        [&](const auto& one) {
            for (const auto& motion : one.handles.at(static_cast<std::size_t>(key.handle)).motions) {
                if (motion.end == key.time) ease.before = slowSidesOf(motion).end;
                if (motion.start == key.time) ease.after = slowSidesOf(motion).start;
            }
        },
        design);
    return ease;
}

AnyDesign withKeyEase(const AnyDesign& design, const std::vector<KeyId>& keys, const KeyEase& ease) {
    return edited(design, keys, [&](auto& handle, double time) { easeKey(handle, time, ease); });
}

template <int Dim>
std::vector<CopiedKey> copiedKeys(const Design<Dim>& design, const std::vector<KeyId>& keys,
                                  const std::vector<Vec<Dim>>& starts) {
    std::vector<CopiedKey> copies;
    double first = kForever;
    for (const KeyId& key : keys) {
        const auto at = static_cast<std::size_t>(key.handle);
        const Vec<Dim> offset = placeAt<Dim>(design.handles.at(at), key.time, starts.at(at)) - starts[at];
        copies.push_back({key.handle, key.time, amountOf<Dim>(offset), easeAt(design, key)});
        first = std::min(first, key.time);
    }
    for (CopiedKey& copy : copies) copy.after -= first;
    std::ranges::stable_sort(copies, {}, &CopiedKey::after);
    return copies;
}

template <int Dim>
std::shared_ptr<const Project> withKeysPasted(const Project& project, const std::vector<CopiedKey>& copies,
                                              double time, const std::vector<Vec<Dim>>& starts,
                                              std::vector<KeyId>& pasted) {
    auto next = copyOf(project);
    pasted.clear();
    for (const CopiedKey& copy : copies) {
        const auto at = static_cast<std::size_t>(copy.handle);
        auto& handle = std::get<Design<Dim>>(next->design).handles.at(at);
        const double when = time + copy.after;
        if (when > handle.activeTo) continue;
        const Vec<Dim> now = placeAt<Dim>(handle, when, starts.at(at));
        const Vec<Dim> by = starts[at] + copy.offset.template head<Dim>() - now;
        if (!poseAt<Dim>(handle, now, by, when)) continue;
        const double key = nearestKey(handle, when);
        easeStraight<Dim>(handle, key, copy.ease);
        pasted.push_back({copy.handle, key});
        next->end = std::max(next->end, key);
    }
    return next;
}

#define WEND_INSTANTIATE(Dim)                                                                      \
    template std::vector<CopiedKey> copiedKeys<Dim>(const Design<Dim>&, const std::vector<KeyId>&, \
                                                    const std::vector<Vec<Dim>>&);                 \
    template std::shared_ptr<const Project> withKeysPasted<Dim>(                                   \
        const Project&, const std::vector<CopiedKey>&, double, const std::vector<Vec<Dim>>&,       \
        std::vector<KeyId>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
