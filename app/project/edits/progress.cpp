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

/// The weights of the inner points of a cubic.
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

template <int Dim>
bool isPlain(const CurveMotion<Dim>& curve) {
    return curve.frame == FrameKind::None && curve.twist == 0 && curve.scale == 1;
}

/// The lengths of a path up to its points.
template <int Dim>
std::vector<double> lengthsAlong(const OffsetPath<Dim>& path) {
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
template <int Dim>
std::vector<TimedCubic<Dim>> easedPolyline(const CurveMotion<Dim>& curve, const Motion<Dim>& motion) {
    std::vector<TimedCubic<Dim>> cubics;
    double from = 0;
    for (const CurvePiece<Dim>& piece : curveOf<Dim>(curve).pieces) {
        const bool isLast = piece.to >= 1;
        const double to = isLast ? 1 : easeInverse(motion.ease, piece.to);
        const Vec<Dim> begin = piece.value(0) - curve.points.front(), way = piece.value(1) - piece.value(0);
        const std::array<double, 4> at = partOf(progressOf(motion.ease), from, to);
        TimedCubic<Dim> cubic;
        for (std::size_t k = 0; k < 4; ++k)
            cubic.points[k] = begin + (at[k] - piece.from) / (piece.to - piece.from) * way;
        cubic.time = {std::lerp(motion.start, motion.end, from), std::lerp(motion.start, motion.end, to)};
        cubics.push_back(cubic);
        from = to;
    }
    return cubics;
}

template <int Dim>
ShownProgress shown(const Motion<Dim>& motion) {
    if (const auto straight = straightProgress<Dim>(motion)) return {*straight, {}, true};
    const auto path = offsetPathOf<Dim>(motion, motion.end);
    const std::vector<double> lengths = path ? lengthsAlong<Dim>(*path) : std::vector<double>{0};
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
template <int Dim>
Motion<Dim> retimed(const OffsetPath<Dim>& path, const Progress& progress, const Vec<Dim>& place) {
    const std::vector<double> lengths = lengthsAlong<Dim>(path);
    const Progress forward{std::clamp(progress.first, 0.0, 1.0), std::clamp(progress.second, 0.0, 1.0)};
    std::vector<double> shares;  // of the time
    for (const double length : lengths) shares.push_back(timeShareOf(forward, length / lengths.back()));
    for (int i = 0; i <= kWaySamples; ++i) shares.push_back(double(i) / kWaySamples);
    std::ranges::sort(shares);
    const double from = path.times.front(), to = path.times.back();
    OffsetPath<Dim> result{{from}, {path.offsets.front()}};
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
    return motionAlong<Dim>(result, place);
}

template <int Dim>
void setProgress(Motion<Dim>& motion, const Progress& progress, const Vec<Dim>& place) {
    const auto preset = easeOf(progress);
    if (straightProgress<Dim>(motion)) {
        Extras extras = motion.extras;
        motion = straightMove<Dim>(*offsetOf<Dim>(motion), {motion.start, motion.end}, progress, place);
        motion.extras = std::move(extras);
        return;
    }
    const auto path = offsetPathOf<Dim>(motion, motion.end);
    const bool moves = path && lengthsAlong<Dim>(*path).back() > 0;
    if (moves && (!preset || std::holds_alternative<Recorded<Dim>>(motion.kind)))
        motion = retimed<Dim>(*path, progress, place);
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

template <int Dim>
std::optional<Progress> straightProgress(const Motion<Dim>& motion) {
    if (std::holds_alternative<Translate<Dim>>(motion.kind)) return progressOf(motion.ease);
    const auto* curve = std::get_if<CurveMotion<Dim>>(&motion.kind);
    if (!curve || !isPlain<Dim>(*curve) || motion.ease != Ease::Linear ||
        curve->interpolation != Interpolation::Bezier || curve->points.size() != 4)
        return {};
    const Vec<Dim> way = curve->points[3] - curve->points[0];
    const double size = way.squaredNorm();
    if (size == 0) return {};
    std::array<double, 2> shares{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec<Dim> offset = curve->points[i + 1] - curve->points[0];
        shares[i] = offset.dot(way) / size;
        if ((offset - shares[i] * way).squaredNorm() > 1e-20 * size) return {};
    }
    return Progress{shares[0], shares[1]};
}

template <int Dim>
Motion<Dim> straightMove(const Vec<Dim>& by, const MotionTime& time, const Progress& progress,
                         const Vec<Dim>& place) {
    const auto preset = easeOf(progress);
    if (preset || by.isZero(0))
        return {Translate<Dim>{by}, time.start, time.end, preset.value_or(Ease::Linear)};
    CurveMotion<Dim> curve;
    curve.points = {place, place + progress.first * by, place + progress.second * by, place + by};
    return {std::move(curve), time.start, time.end};
}

template <int Dim>
std::optional<std::array<Vec<Dim>, 4>> cubicOf(const Motion<Dim>& motion) {
    const Vec<Dim> zero = Vec<Dim>::Zero();
    if (const auto* straight = std::get_if<Translate<Dim>>(&motion.kind)) {
        const Progress progress = progressOf(motion.ease);
        return std::array<Vec<Dim>, 4>{zero, progress.first * straight->by, progress.second * straight->by,
                                       straight->by};
    }
    const auto* curve = std::get_if<CurveMotion<Dim>>(&motion.kind);
    if (!curve || !isPlain<Dim>(*curve) || motion.ease != Ease::Linear ||
        curve->interpolation != Interpolation::Bezier || curve->points.size() != 4)
        return {};
    std::array<Vec<Dim>, 4> points;
    for (std::size_t i = 0; i < 4; ++i) points[i] = curve->points[i] - curve->points[0];
    return points;
}

template <int Dim>
std::vector<TimedCubic<Dim>> cubicsOf(const Motion<Dim>& motion) {
    if (const auto whole = cubicOf<Dim>(motion)) return {{*whole, {motion.start, motion.end}}};
    const auto* curve = std::get_if<CurveMotion<Dim>>(&motion.kind);
    if (!curve || !isPlain<Dim>(*curve)) return {};
    const bool isPolyline = curve->interpolation == Interpolation::Polyline,
               isEven = motion.ease == Ease::Linear;
    if (isPolyline && !isEven) return easedPolyline<Dim>(*curve, motion);
    if (isPolyline || !isEven) return {};
    std::vector<TimedCubic<Dim>> cubics;
    for (const CurvePiece<Dim>& piece : curveOf<Dim>(*curve).pieces) {
        const auto c = [&](int k) -> Vec<Dim> { return piece.coefficients.col(k); };
        const Vec<Dim> from = c(0) - curve->points.front();
        const double start = cubics.empty() ? motion.start : cubics.back().time.end;
        cubics.push_back({{from, from + c(1) / 3, from + (2 * c(1) + c(2)) / 3, from + c(1) + c(2) + c(3)},
                          {start, std::lerp(motion.start, motion.end, piece.to)}});
    }
    cubics.back().time.end = motion.end;
    return cubics;
}

template <int Dim>
Motion<Dim> cubicMove(const std::array<Vec<Dim>, 4>& points, const MotionTime& time) {
    CurveMotion<Dim> curve;
    curve.points.assign(points.begin(), points.end());
    Motion<Dim> motion{std::move(curve), time.start, time.end};
    const auto straight = straightProgress<Dim>(motion);
    if (!straight || !easeOf(*straight)) return motion;
    return straightMove<Dim>(points[3] - points[0], time, *straight, points[0]);
}

template <int Dim>
SlowSides slowSidesOf(const Motion<Dim>& motion) {
    const auto straight = straightProgress<Dim>(motion);
    const Progress progress = straight ? *straight : progressOf(motion.ease);
    return {std::abs(progress.first) < kSameShare, std::abs(1 - progress.second) < kSameShare};
}

template <int Dim>
void setSlowSides(Motion<Dim>& motion, const SlowSides& sides) {
    if (slowSidesOf<Dim>(motion) == sides) return;
    const Ease ease =
        sides.start ? (sides.end ? Ease::InOut : Ease::In) : (sides.end ? Ease::Out : Ease::Linear);
    const auto* curve = std::get_if<CurveMotion<Dim>>(&motion.kind);
    const auto own = curve ? straightProgress<Dim>(motion) : std::nullopt;
    if (!own) {
        motion.ease = ease;
        return;
    }
    const SlowSides before = slowSidesOf<Dim>(motion);
    Progress next = *own;
    if (before.start != sides.start) next.first = sides.start ? 0 : progressOf(ease).first;
    if (before.end != sides.end) next.second = sides.end ? 1 : progressOf(ease).second;
    const Vec<Dim> place = curve->points.front();
    const Vec<Dim> by = curve->points.back() - place;
    Extras extras = motion.extras;
    motion = straightMove<Dim>(by, {motion.start, motion.end}, next, place);
    motion.extras = std::move(extras);
}

ShownProgress shownProgress(const AnyDesign& design, const MotionId& motion) {
    return std::visit(
        [&](const auto& own) {
            return shown(own.handles.at(static_cast<std::size_t>(motion.handle))
                             .motions.at(static_cast<std::size_t>(motion.motion)));
        },
        design);
}

std::vector<MotionId> motionsBetween(const AnyDesign& design, const std::vector<KeyId>& keys) {
    std::vector<MotionId> inner, after, before;
    std::visit(
        [&](const auto& own) {
            for (int h = 0; h < static_cast<int>(own.handles.size()); ++h) {
                const auto& motions = own.handles[static_cast<std::size_t>(h)].motions;
                for (int m = 0; m < static_cast<int>(motions.size()); ++m) {
                    const auto& motion = motions[static_cast<std::size_t>(m)];
                    const bool starts = isAmong(keys, KeyId{h, motion.start}),
                               ends = isAmong(keys, KeyId{h, motion.end});
                    if (starts && ends) inner.push_back({h, m});
                    if (starts) after.push_back({h, m});
                    if (ends) before.push_back({h, m});
                }
            }
        },
        design);
    return !inner.empty() ? inner : !after.empty() ? after : before;
}

template <int Dim>
Design<Dim> withProgress(const Design<Dim>& design, const std::vector<MotionId>& motions,
                         const Progress& progress, const std::vector<Vec<Dim>>& starts) {
    Design<Dim> result = design;
    for (const MotionId& id : motions) {
        const auto at = static_cast<std::size_t>(id.handle);
        Motion<Dim>& motion = result.handles.at(at).motions.at(static_cast<std::size_t>(id.motion));
        const HandleTimeline<Dim> timeline(design.handles[at]);
        setProgress<Dim>(motion, progress,
                         timeline.bodyAt(motion.start, Side::Before).position(starts.at(at)));
    }
    return result;
}

#define WEND_INSTANTIATE(Dim)                                                                   \
    template std::optional<Progress> straightProgress<Dim>(const Motion<Dim>&);                 \
    template Motion<Dim> straightMove<Dim>(const Vec<Dim>&, const MotionTime&, const Progress&, \
                                           const Vec<Dim>&);                                    \
    template std::optional<std::array<Vec<Dim>, 4>> cubicOf<Dim>(const Motion<Dim>&);           \
    template std::vector<TimedCubic<Dim>> cubicsOf<Dim>(const Motion<Dim>&);                    \
    template Motion<Dim> cubicMove<Dim>(const std::array<Vec<Dim>, 4>&, const MotionTime&);     \
    template SlowSides slowSidesOf<Dim>(const Motion<Dim>&);                                    \
    template void setSlowSides<Dim>(Motion<Dim>&, const SlowSides&);                            \
    template Design<Dim> withProgress<Dim>(const Design<Dim>&, const std::vector<MotionId>&,    \
                                           const Progress&, const std::vector<Vec<Dim>>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
