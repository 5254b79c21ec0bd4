#include "app/project/edits/progress.h"

#include <algorithm>
#include <cmath>

#include "app/project/design.h"
#include "app/project/edits/bezier_edits.h"
#include "app/project/edits/offset_path.h"
#include "core/motion/constraints.h"
#include "core/motion/easing.h"

namespace wend {

namespace {

constexpr double kSameShare = 1e-12;  // of the way: what rounding may change
constexpr int kWaySamples = 64;       // of a way that is no straight line

/// Returns the weights of the inner control points of a cubic Bézier curve.
std::array<double, 2> innerWeights(double s) {
    return {3 * s * (1 - s) * (1 - s), 3 * s * s * (1 - s)};
}

/// Returns s with p(s) = u. The progress must not decrease, as with handles from 0 to 1.
double timeShareOf(const Progress& progress, double u) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (progress.at(middle) < u ? low : high) = middle;
    }
    return (low + high) / 2;
}

bool isPlain(const CurveMotion<3>& curve) {
    return curve.frame == FrameKind::None && curve.twist == 0 && curve.scale == 1;
}

/// Returns the lengths of a path up to its points.
std::vector<double> lengthsAlong(const OffsetPath& path) {
    std::vector<double> lengths = {0};
    for (std::size_t i = 1; i < path.offsets.size(); ++i)
        lengths.push_back(lengths.back() + (path.offsets[i] - path.offsets[i - 1]).norm());
    return lengths;
}

/// Returns the value at x of a function that is linear between its points.
double valueAt(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
    const auto after = std::ranges::upper_bound(xs, x) - xs.begin();
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(after), 1, xs.size() - 1);
    const double width = xs[i] - xs[i - 1];
    const double part = width > 0 ? std::clamp((x - xs[i - 1]) / width, 0.0, 1.0) : 1;
    return std::lerp(ys[i - 1], ys[i], part);
}

/// Returns the curve nearest to shares of the way at even times, by least squares, without a step back.
Progress nearestCurve(const std::vector<double>& way) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < way.size(); ++i) {
        const double s = double(i) / double(way.size() - 1);
        const std::array<double, 2> weights = innerWeights(s);
        const Eigen::Vector2d row(weights[0], weights[1]);
        normal += row * row.transpose();
        right += row * (way[i] - s * s * s);
    }
    const Eigen::Vector2d found = normal.inverse() * right;
    return {std::clamp(found[0], 0.0, 1.0), std::clamp(found[1], 0.0, 1.0)};
}

/// Returns the control values of a progress on a part of the time, by its polar form.
std::array<double, 4> partOf(const Progress& progress, double from, double to) {
    const auto polar = [&](double a, double b, double c) {
        const auto between = [](double s, double x, double y) { return (1 - s) * x + s * y; };
        const double first = between(a, 0, progress.first),
                     second = between(a, progress.first, progress.second),
                     third = between(a, progress.second, 1);
        return between(c, between(b, first, second), between(b, second, third));
    };
    return {polar(from, from, from), polar(from, from, to), polar(from, to, to), polar(to, to, to)};
}

/// Returns the cubics of an eased polyline: its parts are straight.
std::vector<TimedCubic> easedPolyline(const CurveMotion<3>& curve, const PinMotion& motion) {
    std::vector<TimedCubic> cubics;
    double from = 0;
    for (const CurvePiece<3>& piece : curveOf(curve).pieces) {
        const bool isLast = piece.to >= 1;
        const double to = isLast ? 1 : easeInverse(motion.ease, piece.to);
        const Vec3 begin = piece.value(0) - curve.points.front(), way = piece.value(1) - piece.value(0);
        const std::array<double, 4> at = partOf(progressOf(motion.ease), from, to);
        TimedCubic cubic;
        for (std::size_t k = 0; k < 4; ++k)
            cubic.points[k] = begin + (at[k] - piece.from) / (piece.to - piece.from) * way;
        cubic.time = {std::lerp(motion.start, motion.end, from), std::lerp(motion.start, motion.end, to)};
        cubics.push_back(cubic);
        from = to;
    }
    return cubics;
}

ShownProgress shown(const PinMotion& motion) {
    if (const auto straight = straightProgress(motion)) return {*straight, {}, true};
    const auto path = offsetPathOf(motion, motion.end);
    const std::vector<double> lengths = path ? lengthsAlong(*path) : std::vector<double>{0};
    if (lengths.back() == 0) return {progressOf(motion.ease), {}, false};
    ShownProgress result{{}, {}, true};
    for (int i = 0; i <= kWaySamples; ++i) {
        const double time = std::lerp(motion.start, motion.end, double(i) / kWaySamples);
        result.way.push_back(valueAt(path->times, lengths, time) / lengths.back());
    }
    result.curve = nearestCurve(result.way);
    return result;
}

/// Returns a recording of a path on which the handle has come as far as the progress says.
PinMotion retimed(const OffsetPath& path, const Progress& progress, const Vec3& place) {
    const std::vector<double> lengths = lengthsAlong(path);
    const Progress forward{std::clamp(progress.first, 0.0, 1.0), std::clamp(progress.second, 0.0, 1.0)};
    std::vector<double> shares;  // of the time
    for (const double length : lengths) shares.push_back(timeShareOf(forward, length / lengths.back()));
    for (int i = 0; i <= kWaySamples; ++i) shares.push_back(double(i) / kWaySamples);
    std::ranges::sort(shares);
    const double from = path.times.front(), to = path.times.back();
    OffsetPath result{{from}, {path.offsets.front()}};
    for (const double s : shares) {
        const double time = std::lerp(from, to, s);
        if (time <= result.times.back() || s >= 1) continue;
        // The path as a function of its length rather than of its time.
        const double at = valueAt(lengths, path.times, forward.at(s) * lengths.back());
        result.times.push_back(time);
        result.offsets.push_back(path.at(at));
    }
    result.times.push_back(to);
    result.offsets.push_back(path.offsets.back());
    return motionAlong(result, place);
}

void setProgress(PinMotion& motion, const Progress& progress, const Vec3& place) {
    const auto preset = easeOf(progress);
    if (straightProgress(motion)) {
        Extras extras = motion.extras;
        motion = straightMove(*offsetOf(motion), {motion.start, motion.end}, progress, place);
        motion.extras = std::move(extras);
        return;
    }
    const auto path = offsetPathOf(motion, motion.end);
    const bool moves = path && lengthsAlong(*path).back() > 0;
    if (moves && (!preset || std::holds_alternative<Recorded<3>>(motion.kind)))
        motion = retimed(*path, progress, place);
    else if (preset)
        motion.ease = *preset;
}

}  // namespace

double Progress::at(double s) const {
    const std::array<double, 2> weights = innerWeights(s);
    return weights[0] * first + weights[1] * second + s * s * s;
}

Progress progressOf(Ease ease) {
    switch (ease) {
        case Ease::Linear:
            break;
        case Ease::In:
            return {0, 1.0 / 3};
        case Ease::Out:
            return {2.0 / 3, 1};
        case Ease::InOut:
            return {0, 1};
    }
    return {};
}

std::optional<Ease> easeOf(const Progress& progress) {
    for (const Ease ease : {Ease::Linear, Ease::In, Ease::Out, Ease::InOut}) {
        const Progress own = progressOf(ease);
        if (std::abs(own.first - progress.first) + std::abs(own.second - progress.second) < kSameShare)
            return ease;
    }
    return {};
}

std::optional<Progress> straightProgress(const PinMotion& motion) {
    if (std::holds_alternative<Translate<3>>(motion.kind)) return progressOf(motion.ease);
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    if (!curve || !isPlain(*curve) || motion.ease != Ease::Linear ||
        curve->interpolation != Interpolation::Bezier || curve->points.size() != 4)
        return {};
    const Vec3 way = curve->points[3] - curve->points[0];
    const double size = way.squaredNorm();
    if (size == 0) return {};
    std::array<double, 2> shares{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 offset = curve->points[i + 1] - curve->points[0];
        shares[i] = offset.dot(way) / size;
        if ((offset - shares[i] * way).squaredNorm() > 1e-20 * size) return {};
    }
    return Progress{shares[0], shares[1]};
}

PinMotion straightMove(const Vec3& by, const MotionTime& time, const Progress& progress, const Vec3& place) {
    const auto preset = easeOf(progress);
    if (preset || by.isZero(0))
        return {Translate<3>{by}, time.start, time.end, preset.value_or(Ease::Linear)};
    CurveMotion<3> curve;
    curve.points = {place, place + progress.first * by, place + progress.second * by, place + by};
    return {std::move(curve), time.start, time.end};
}

std::optional<std::array<Vec3, 4>> cubicOf(const PinMotion& motion) {
    const Vec3 zero = Vec3::Zero();
    if (const auto* straight = std::get_if<Translate<3>>(&motion.kind)) {
        const Progress progress = progressOf(motion.ease);
        return std::array<Vec3, 4>{zero, progress.first * straight->by, progress.second * straight->by,
                                   straight->by};
    }
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    if (!curve || !isPlain(*curve) || motion.ease != Ease::Linear ||
        curve->interpolation != Interpolation::Bezier || curve->points.size() != 4)
        return {};
    std::array<Vec3, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = curve->points[i] - curve->points[0];
    return points;
}

std::vector<TimedCubic> cubicsOf(const PinMotion& motion) {
    if (const auto whole = cubicOf(motion)) return {{*whole, {motion.start, motion.end}}};
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    if (!curve || !isPlain(*curve)) return {};
    const bool isPolyline = curve->interpolation == Interpolation::Polyline,
               isEven = motion.ease == Ease::Linear;
    if (isPolyline && !isEven) return easedPolyline(*curve, motion);
    if (isPolyline || !isEven) return {};
    std::vector<TimedCubic> cubics;
    for (const CurvePiece<3>& piece : curveOf(*curve).pieces) {
        const auto c = [&](int k) -> Vec3 { return piece.coefficients.col(k); };
        const Vec3 from = c(0) - curve->points.front();
        const double start = cubics.empty() ? motion.start : cubics.back().time.end;
        cubics.push_back({{from, from + c(1) / 3, from + (2 * c(1) + c(2)) / 3, from + c(1) + c(2) + c(3)},
                          {start, std::lerp(motion.start, motion.end, piece.to)}});
    }
    cubics.back().time.end = motion.end;
    return cubics;
}

PinMotion cubicMove(const std::array<Vec3, 4>& points, const MotionTime& time) {
    CurveMotion<3> curve;
    curve.points.assign(points.begin(), points.end());
    PinMotion motion{std::move(curve), time.start, time.end};
    const auto straight = straightProgress(motion);
    if (!straight || !easeOf(*straight)) return motion;
    return straightMove(points[3] - points[0], time, *straight, points[0]);
}

SlowSides slowSidesOf(const PinMotion& motion) {
    const auto straight = straightProgress(motion);
    const Progress progress = straight ? *straight : progressOf(motion.ease);
    return {std::abs(progress.first) < kSameShare, std::abs(1 - progress.second) < kSameShare};
}

void setSlowSides(PinMotion& motion, const SlowSides& sides) {
    if (slowSidesOf(motion) == sides) return;
    const Ease ease =
        sides.start ? (sides.end ? Ease::InOut : Ease::In) : (sides.end ? Ease::Out : Ease::Linear);
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    const auto own = curve ? straightProgress(motion) : std::nullopt;
    if (!own) {
        motion.ease = ease;
        return;
    }
    const SlowSides before = slowSidesOf(motion);
    Progress next = *own;
    if (before.start != sides.start) next.first = sides.start ? 0 : progressOf(ease).first;
    if (before.end != sides.end) next.second = sides.end ? 1 : progressOf(ease).second;
    const Vec3 place = curve->points.front();
    const Vec3 by = curve->points.back() - place;
    Extras extras = motion.extras;
    motion = straightMove(by, {motion.start, motion.end}, next, place);
    motion.extras = std::move(extras);
}

ShownProgress shownProgress(const Design& design, const MotionId& motion) {
    return shown(design.handles.at(static_cast<std::size_t>(motion.handle))
                     .motions.at(static_cast<std::size_t>(motion.motion)));
}

std::vector<MotionId> motionsBetween(const Design& design, const std::vector<KeyId>& keys) {
    std::vector<MotionId> inner, after, before;
    for (int h = 0; h < static_cast<int>(design.handles.size()); ++h) {
        const auto& motions = design.handles[static_cast<std::size_t>(h)].motions;
        for (int m = 0; m < static_cast<int>(motions.size()); ++m) {
            const PinMotion& motion = motions[static_cast<std::size_t>(m)];
            const bool starts = isAmong(keys, KeyId{h, motion.start}),
                       ends = isAmong(keys, KeyId{h, motion.end});
            if (starts && ends) inner.push_back({h, m});
            if (starts) after.push_back({h, m});
            if (ends) before.push_back({h, m});
        }
    }
    return !inner.empty() ? inner : !after.empty() ? after : before;
}

Design withProgress(const Design& design, const std::vector<MotionId>& motions, const Progress& progress,
                    const std::vector<Vec3>& starts) {
    Design result = design;
    for (const MotionId& id : motions) {
        const auto at = static_cast<std::size_t>(id.handle);
        PinMotion& motion = result.handles.at(at).motions.at(static_cast<std::size_t>(id.motion));
        const HandleTimeline<3> timeline(handleIn<3>(design.handles[at]));
        setProgress(motion, progress, timeline.bodyAt(motion.start, Side::Before).position(starts.at(at)));
    }
    return result;
}

}  // namespace wend
