#include "app/document/edits/pose_edits.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/document/edits/bezier_edits.h"
#include "app/document/edits/film_time.h"
#include "app/document/edits/timing_edits.h"
#include "app/document/project.h"
#include "core/motion/curve.h"
#include "core/motion/easing.h"

namespace wend {

namespace {

constexpr int kSamples = 48;  // of a motion that is no polygon in time

/// Offsets from the start of a motion, by time; linear in between.
template <int Dim>
struct Way {
    std::vector<double> times;
    std::vector<Vec<Dim>> offsets;

    Vec<Dim> at(double time) const {
        const auto after = std::ranges::lower_bound(times, time) - times.begin();
        if (after == 0) return offsets.front();
        const auto i = std::min(static_cast<std::size_t>(after), times.size() - 1);
        const double part = (time - times[i - 1]) / (times[i] - times[i - 1]);
        return offsets[i - 1] + std::clamp(part, 0.0, 1.0) * (offsets[i] - offsets[i - 1]);
    }
    /// The offsets plus a displacement, times a factor that is linear in time.
    Way led(const Vec<Dim>& by, double first, double last) const {
        Way result = *this;
        for (std::size_t i = 0; i < times.size(); ++i)
            result.offsets[i] +=
                by * std::lerp(first, last, (times[i] - times.front()) / (times.back() - times.front()));
        const Vec<Dim> start = result.offsets.front();
        for (Vec<Dim>& offset : result.offsets) offset -= start;
        return result;
    }
};

/// Returns the offset of a recording at a fraction of its own time.
template <int Dim>
Vec<Dim> offsetAt(const Recorded<Dim>& stroke, double s) {
    const double time = std::lerp(stroke.times.front(), stroke.times.back(), s);
    return Way<Dim>{stroke.times, stroke.points}.at(time) - stroke.points.front();
}

/// Returns the path of a motion that only translates, exact at one time; nothing for any other motion.
template <int Dim>
std::optional<Way<Dim>> wayOf(const Motion<Dim>& motion, double time) {
    const auto timeAt = [&](double s) { return std::lerp(motion.start, motion.end, s); };
    Way<Dim> way;
    const auto sample = [&](auto&& offset) {
        std::set<double> parts = {(time - motion.start) / (motion.end - motion.start)};
        for (int i = 0; i <= kSamples; ++i) parts.insert(static_cast<double>(i) / kSamples);
        for (const double s : parts) {
            if (s < 0 || s > 1) continue;
            way.times.push_back(timeAt(s));
            way.offsets.push_back(offset(ease(motion.ease, s)));
        }
    };
    const bool isEven = motion.ease == Ease::Linear;
    if (const auto* translate = std::get_if<Translate<Dim>>(&motion.kind)) {
        if (isEven)
            way = {{motion.start, motion.end}, {Vec<Dim>::Zero(), translate->by}};
        else
            sample([&](double u) { return Vec<Dim>(u * translate->by); });
        return way;
    }
    if (const auto* stroke = std::get_if<Recorded<Dim>>(&motion.kind)) {
        if (!isEven) {
            sample([&](double u) { return offsetAt<Dim>(*stroke, u); });
            return way;
        }
        const double from = stroke->times.front(), length = stroke->times.back() - from;
        for (std::size_t i = 0; i < stroke->times.size(); ++i) {
            way.times.push_back(timeAt((stroke->times[i] - from) / length));
            way.offsets.push_back(stroke->points[i] - stroke->points.front());
        }
        return way;
    }
    const auto* curve = std::get_if<CurveMotion<Dim>>(&motion.kind);
    if (!curve || curve->frame != FrameKind::None || curve->scale != 1 || curve->twist != 0) return {};
    const Curve<Dim> line = curveOf<Dim>(*curve);
    sample([&](double u) {
        const int k = line.locate(u, 0, static_cast<int>(line.pieces.size()));
        return Vec<Dim>(line.pieces[k].value(line.pieces[k].local(u)) - line.pieces.front().value(0));
    });
    return way;
}

template <int Dim>
Motion<Dim> motionAlong(const Way<Dim>& way, const Vec<Dim>& place) {
    Recorded<Dim> stroke;
    const double from = way.times.front(), length = way.times.back() - from;
    for (std::size_t i = 0; i < way.times.size(); ++i) {
        stroke.times.push_back((way.times[i] - from) / length);
        stroke.points.push_back(place + way.offsets[i]);
    }
    stroke.times.back() = 1;
    Motion<Dim> motion;
    motion.kind = std::move(stroke);
    motion.start = from;
    motion.end = way.times.back();
    return motion;
}

/// Returns both parts of a path that is split at a time within it.
template <int Dim>
std::pair<Way<Dim>, Way<Dim>> split(const Way<Dim>& way, double time) {
    const Vec<Dim> middle = way.at(time);
    std::pair<Way<Dim>, Way<Dim>> parts;
    parts.second = {{time}, {middle}};
    for (std::size_t i = 0; i < way.times.size(); ++i) {
        Way<Dim>& part = way.times[i] < time ? parts.first : parts.second;
        if (way.times[i] == time) continue;
        part.times.push_back(way.times[i]);
        part.offsets.push_back(way.offsets[i]);
    }
    parts.first.times.push_back(time);
    parts.first.offsets.push_back(middle);
    return parts;
}

/// Leads the motions of one handle through a pose; false if they cannot be led.
template <int Dim>
bool pose(Handle<Dim>& handle, const Vec<Dim>& place, const Vec<Dim>& by, double time) {
    auto& motions = handle.motions;
    const auto isNear = [&](double t) { return std::abs(t - time) < kShortestMotion; };
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const Motion<Dim>& own = motions[i];
        if (!(own.start < time && time < own.end) || isNear(own.start) || isNear(own.end)) continue;
        const auto way = wayOf<Dim>(own, time);
        if (!way) return false;
        const auto [before, after] = split<Dim>(*way, time);
        const Vec<Dim> start = place - way->at(time);
        motions[i] = motionAlong<Dim>(before.led(by, 0, 1), start);
        motions.insert(motions.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       motionAlong<Dim>(after.led(by, 1, 0), place + by));
        return true;
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
        const auto way = wayOf<Dim>(*previous, time);
        if (!way) return false;
        key = previous->end;
        result.push_back(motionAlong<Dim>(way->led(by, 0, 1), place - way->offsets.back()));
    } else {
        const double from =
            std::max(result.empty() ? 0 : result.back().end, std::max(handle.activeFrom, 0.0));
        if (next != motions.end() && isNear(next->start)) key = next->start;
        if (key - from < kShortestMotion) return false;
        result.push_back(motionAlong<Dim>({{from, key}, {Vec<Dim>::Zero(), by}}, place));
    }
    if (next != motions.end()) {
        const bool follows = next->start - key < kShortestMotion;
        const auto way = follows ? wayOf<Dim>(*next, time) : std::nullopt;
        if (follows && !way) return false;
        if (follows)
            result.push_back(motionAlong<Dim>(way->led(by, 1, 0), place + by));
        else
            result.push_back(motionAlong<Dim>({{key, next->start}, {Vec<Dim>::Zero(), -by}}, place + by));
        result.insert(result.end(), follows ? next + 1 : next, motions.end());
    }
    motions = std::move(result);
    return true;
}

}  // namespace

template <int Dim>
std::optional<Project> withPose(const Project& project, const Gesture& gesture,
                                const std::vector<Vec<Dim>>& starts) {
    if (gesture.grip.kind != Grip::Kind::Move) return {};
    Project next = project;
    const Vec<Dim> by = gesture.path.back().template head<Dim>();
    for (std::size_t i = 0; i < gesture.handles.size(); ++i) {
        auto& handle =
            std::get<Design<Dim>>(next.design).handles.at(static_cast<std::size_t>(gesture.handles[i]));
        if (!pose<Dim>(handle, starts[i], by, gesture.from)) return {};
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
    double way = 0;
    for (std::size_t i = 0; i < gesture.path.size(); ++i) {
        if (i > 0) way += (gesture.path[i] - gesture.path[i - 1]).norm();
        added.times.push_back(whole > 0 ? length * way / whole : 0);
    }
    added.times.back() = length;
    return withGesture<Dim>(project, added, starts);
}

#define WEND_INSTANTIATE(Dim)                                                                            \
    template std::optional<Project> withPose<Dim>(const Project&, const Gesture&,                        \
                                                  const std::vector<Vec<Dim>>&);                         \
    template Project withPoseAppended<Dim>(const Project&, const Gesture&, const std::vector<Vec<Dim>>&, \
                                           double)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
