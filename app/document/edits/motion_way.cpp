#include "app/document/edits/motion_way.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/document/edits/bezier_edits.h"
#include "core/motion/curve.h"
#include "core/motion/easing.h"

namespace wend {

namespace {

constexpr int kSamples = 48;     // of a motion that is no polygon in time
constexpr double kApart = 1e-9;  // of a motion's duration, between its samples

/// Returns the offset of a recording at a fraction of its own time.
template <int Dim>
Vec<Dim> offsetAt(const Recorded<Dim>& stroke, double s) {
    const double time = std::lerp(stroke.times.front(), stroke.times.back(), s);
    return MotionWay<Dim>{stroke.times, stroke.points}.at(time) - stroke.points.front();
}

}  // namespace

template <int Dim>
Vec<Dim> MotionWay<Dim>::at(double time) const {
    const auto after = std::ranges::lower_bound(times, time) - times.begin();
    if (after == 0) return offsets.front();
    const auto i = std::min(static_cast<std::size_t>(after), times.size() - 1);
    const double part = (time - times[i - 1]) / (times[i] - times[i - 1]);
    return offsets[i - 1] + std::clamp(part, 0.0, 1.0) * (offsets[i] - offsets[i - 1]);
}

template <int Dim>
MotionWay<Dim> MotionWay<Dim>::led(const Vec<Dim>& by, double first, double last) const {
    MotionWay result = *this;
    for (std::size_t i = 0; i < times.size(); ++i)
        result.offsets[i] +=
            by * std::lerp(first, last, (times[i] - times.front()) / (times.back() - times.front()));
    const Vec<Dim> start = result.offsets.front();
    for (Vec<Dim>& offset : result.offsets) offset -= start;
    return result;
}

template <int Dim>
std::optional<MotionWay<Dim>> wayOf(const Motion<Dim>& motion, double time) {
    const auto timeAt = [&](double s) { return std::lerp(motion.start, motion.end, s); };
    MotionWay<Dim> way;
    const auto sample = [&](auto&& offset) {
        const double own = (time - motion.start) / (motion.end - motion.start);
        std::set<double> parts = {0, 1};
        for (int i = 1; i < kSamples; ++i)
            if (std::abs(double(i) / kSamples - own) > kApart) parts.insert(double(i) / kSamples);
        if (own > kApart && own < 1 - kApart) parts.insert(own);
        for (const double s : parts) {
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
std::optional<Vec<Dim>> offsetOf(const Motion<Dim>& motion) {
    const auto way = wayOf<Dim>(motion, motion.end);
    return way ? std::optional(way->offsets.back()) : std::nullopt;
}

template <int Dim>
Motion<Dim> motionAlong(const MotionWay<Dim>& way, const Vec<Dim>& place) {
    const double from = way.times.front(), length = way.times.back() - from;
    if (way.times.size() == 2)
        return {Translate<Dim>{way.offsets.back() - way.offsets.front()}, from, way.times.back()};
    Recorded<Dim> stroke;
    for (std::size_t i = 0; i < way.times.size(); ++i) {
        const bool isLast = i + 1 == way.times.size();
        const double s = isLast ? 1 : (way.times[i] - from) / length;
        if (i > 0 && !isLast && (s < stroke.times.back() + kApart || s > 1 - kApart)) continue;
        stroke.times.push_back(s);
        stroke.points.push_back(place + way.offsets[i]);
    }
    Motion<Dim> motion;
    motion.kind = std::move(stroke);
    motion.start = from;
    motion.end = way.times.back();
    return motion;
}

template <int Dim>
std::pair<MotionWay<Dim>, MotionWay<Dim>> split(const MotionWay<Dim>& way, double time) {
    const Vec<Dim> middle = way.at(time);
    std::pair<MotionWay<Dim>, MotionWay<Dim>> parts;
    parts.second = {{time}, {middle}};
    for (std::size_t i = 0; i < way.times.size(); ++i) {
        MotionWay<Dim>& part = way.times[i] < time ? parts.first : parts.second;
        if (way.times[i] == time) continue;
        part.times.push_back(way.times[i]);
        part.offsets.push_back(way.offsets[i]);
    }
    parts.first.times.push_back(time);
    parts.first.offsets.push_back(middle);
    return parts;
}

template <int Dim>
std::optional<Motion<Dim>> led(const Motion<Dim>& motion, const Vec<Dim>& by, double first, double last,
                               const Vec<Dim>& place) {
    if (const auto* straight = std::get_if<Translate<Dim>>(&motion.kind)) {
        Motion<Dim> result = motion;
        result.kind = Translate<Dim>{straight->by + (last - first) * by};
        return result;
    }
    const auto way = wayOf<Dim>(motion, motion.end);
    return way ? std::optional(motionAlong<Dim>(way->led(by, first, last), place)) : std::nullopt;
}

#define WEND_INSTANTIATE(Dim)                                                                         \
    template struct MotionWay<Dim>;                                                                   \
    template std::optional<MotionWay<Dim>> wayOf<Dim>(const Motion<Dim>&, double);                    \
    template std::optional<Vec<Dim>> offsetOf<Dim>(const Motion<Dim>&);                               \
    template std::pair<MotionWay<Dim>, MotionWay<Dim>> split<Dim>(const MotionWay<Dim>&, double);     \
    template Motion<Dim> motionAlong<Dim>(const MotionWay<Dim>&, const Vec<Dim>&);                    \
    template std::optional<Motion<Dim>> led<Dim>(const Motion<Dim>&, const Vec<Dim>&, double, double, \
                                                 const Vec<Dim>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
