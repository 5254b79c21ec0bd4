#include "app/project/edits/grown_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "app/project/edits/bezier_edits.h"
#include "app/project/edits/offset_path.h"
#include "app/project/edits/progress.h"
#include "core/motion/easing.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr double kJoint = 1e-9;  // part of a piece that is not divided off
constexpr int kCompared = 32;    // shares of the time at which easings are compared

/// Returns the easing that is nearest to the part of another one between two shares of the time.
Ease nearestEase(Ease whole, double from, double to) {
    const double begin = ease(whole, from), way = ease(whole, to) - begin;
    const auto off = [&](Ease kind) {
        double most = 0;
        for (int i = 1; i < kCompared; ++i) {
            const double s = static_cast<double>(i) / kCompared;
            most =
                std::max(most, std::abs((ease(whole, std::lerp(from, to, s)) - begin) / way - ease(kind, s)));
        }
        return most;
    };
    return std::ranges::min(std::array{Ease::Linear, Ease::In, Ease::Out, Ease::InOut}, {}, off);
}

/// Returns the curve of a motion that grows without turning; null for others.
template <int Dim>
const CurveMotion<Dim>* growthOf(const Motion<Dim>& motion) {
    const auto* curve = std::get_if<CurveMotion<Dim>>(&motion.kind);
    const bool grows = curve && curve->scale != 1 && curve->frame == FrameKind::None && curve->twist == 0;
    return grows ? curve : nullptr;
}

/// Returns the cubics of an even growth's path, which are absolute.
template <int Dim>
std::vector<TimedCubic<Dim>> pathOf(const Motion<Dim>& motion, const CurveMotion<Dim>& curve) {
    Motion<Dim> path = motion;
    path.ease = Ease::Linear;
    auto& plain = std::get<CurveMotion<Dim>>(path.kind);
    plain.scale = 1;
    if (curve.interpolation == Interpolation::Polyline && curve.points.size() == 2) {  // as a cubic
        const Vec<Dim>&from = curve.points[0], &to = curve.points[1];
        plain.points = {from, from + (to - from) / 3, from + 2 * (to - from) / 3, to};
        plain.interpolation = Interpolation::Bezier;
    }
    auto pieces = cubicsOf<Dim>(path);
    for (TimedCubic<Dim>& piece : pieces)
        for (Vec<Dim>& point : piece.points) point += curve.points.front();
    return pieces;
}

/// Divides the piece that holds the time there, unless it begins or ends then.
template <int Dim>
void divide(std::vector<TimedCubic<Dim>>& pieces, double time) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const TimedCubic<Dim> own = pieces[i];
        const double share = (time - own.time.start) / (own.time.end - own.time.start);
        if (share < kJoint || share > 1 - kJoint) continue;
        const std::vector<Vec<Dim>> both = splitBezier<Dim>({own.points.begin(), own.points.end()}, 0, share);
        pieces[i] = {{both[0], both[1], both[2], both[3]}, {own.time.start, time}};
        pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                      {{both[3], both[4], both[5], both[6]}, {time, own.time.end}});
        return;
    }
}

template <int Dim>
std::vector<Motion<Dim>> growthThrough(const Motion<Dim>& motion, const CurveMotion<Dim>& curve,
                                       const Vec<Dim>& by, double time) {
    auto pieces = pathOf<Dim>(motion, curve);
    divide<Dim>(pieces, time);
    const auto scaleAt = [&](double t) {
        return std::lerp(1.0, curve.scale, (t - motion.start) / (motion.end - motion.start));
    };
    std::vector<Motion<Dim>> result;
    for (const TimedCubic<Dim>& piece : pieces) {
        CurveMotion<Dim> part;
        for (std::size_t k = 0; k < 4; ++k) {
            const double t = std::lerp(piece.time.start, piece.time.end, static_cast<double>(k) / 3);
            const double factor = t <= time ? (t - motion.start) / (time - motion.start)
                                            : (motion.end - t) / (motion.end - time);
            part.points.push_back(piece.points[k] + factor * by);
        }
        part.scale = scaleAt(piece.time.end) / scaleAt(piece.time.start);
        result.push_back({std::move(part), piece.time.start, piece.time.end});
    }
    return result;
}

/// Lets parts of an even motion begin and end when an eased one is where they do; `even` becomes `time`.
template <int Dim>
void easeAs(const Motion<Dim>& whole, double even, double time, std::vector<Motion<Dim>>& parts) {
    if (whole.ease == Ease::Linear) return;
    const double length = whole.end - whole.start;
    const auto timeOf = [&](double t) {
        if (t == even) return time;
        const double share = (t - whole.start) / length;
        return share >= 1 ? whole.end : whole.start + easeInverse(whole.ease, share) * length;
    };
    for (Motion<Dim>& part : parts) {
        part.start = timeOf(part.start);
        part.end = timeOf(part.end);
        part.ease =
            nearestEase(whole.ease, (part.start - whole.start) / length, (part.end - whole.start) / length);
    }
}

/// The displacements times a factor, plus a common one.
template <int Dim>
FieldMotion<Dim> scaledField(const FieldMotion<Dim>& field, double factor, const Vec<Dim>& by) {
    auto values = *field.values;
    for (auto& [vertex, displacement] : values) displacement = factor * displacement + by;
    FieldMotion<Dim> result;
    result.values = std::make_shared<const Displacements<Dim>>(std::move(values));
    return result;
}

}  // namespace

template <int Dim>
std::vector<Motion<Dim>> ledWhileGrowing(const Motion<Dim>& motion, const Vec<Dim>& by, double time) {
    const double length = motion.end - motion.start,
                 share = ease(motion.ease, (time - motion.start) / length);
    const double even = motion.ease == Ease::Linear ? time : motion.start + share * length;
    std::vector<Motion<Dim>> parts;
    if (const auto* curve = growthOf<Dim>(motion)) {
        parts = growthThrough<Dim>(motion, *curve, by, even);
    } else if (const auto* field = std::get_if<FieldMotion<Dim>>(&motion.kind)) {
        parts = {{scaledField<Dim>(*field, share, by), motion.start, even},
                 {scaledField<Dim>(*field, 1 - share, -by), even, motion.end}};
    }
    easeAs<Dim>(motion, even, time, parts);
    return parts;
}

template <int Dim>
std::vector<Motion<Dim>> ledGrowth(const Motion<Dim>& motion, const Vec<Dim>& by, double first, double last) {
    Motion<Dim> result = motion;
    if (const auto* field = std::get_if<FieldMotion<Dim>>(&motion.kind)) {
        result.kind = scaledField<Dim>(*field, 1, (last - first) * by);
        return {result};
    }
    const auto* curve = growthOf<Dim>(motion);
    if (!curve || curve->interpolation != Interpolation::Bezier) return {};
    auto& points = std::get<CurveMotion<Dim>>(result.kind).points;
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] +=
            std::lerp(first, last, static_cast<double>(i) / static_cast<double>(points.size() - 1)) * by;
    return {result};
}

/// Returns the field of displacements of two motions that follow each other, of which one at least is a field
/// and the other a field or a translation.
template <int Dim>
std::optional<Motion<Dim>> joinedFields(const Motion<Dim>& before, const Motion<Dim>& after) {
    std::map<int, Vec<Dim>> sum;
    const auto *one = std::get_if<FieldMotion<Dim>>(&before.kind),
               *two = std::get_if<FieldMotion<Dim>>(&after.kind);
    const auto first = offsetOf<Dim>(before), second = offsetOf<Dim>(after);
    if (!(one || two) || !(one || first) || !(two || second)) return {};
    for (const auto* field : {one, two})
        if (field)
            for (const auto& [vertex, displacement] : *field->values)
                sum.try_emplace(vertex, Vec<Dim>::Zero()).first->second += displacement;
    if (!one || !two)
        for (auto& [vertex, displacement] : sum) displacement += one ? *second : *first;
    FieldMotion<Dim> whole;
    whole.values = std::make_shared<const Displacements<Dim>>(sum.begin(), sum.end());
    return Motion<Dim>{std::move(whole), before.start, after.end};
}

template <int Dim>
std::optional<Motion<Dim>> joinedGrowth(const Motion<Dim>& before, const Motion<Dim>& after) {
    if (auto fields = joinedFields<Dim>(before, after)) return fields;
    const auto *one = growthOf<Dim>(before), *two = growthOf<Dim>(after);
    if ((!one && !offsetOf<Dim>(before)) || (!two && !offsetOf<Dim>(after)) || !(one || two)) return {};
    const auto first = Trajectory<Dim>(before).at(before.end, Side::Before).position,
               second = Trajectory<Dim>(after).at(after.end, Side::Before).position;
    const Vec<Dim> from = (one ? one : two)->points.front(), to = second(first(from));
    CurveMotion<Dim> whole;
    whole.points = {from, from + (to - from) / 3, from + 2 * (to - from) / 3, to};
    whole.scale = (one ? one->scale : 1) * (two ? two->scale : 1);
    return Motion<Dim>{std::move(whole), before.start, after.end};
}

#define WEND_INSTANTIATE(Dim)                                                                            \
    template std::optional<Motion<Dim>> joinedGrowth<Dim>(const Motion<Dim>&, const Motion<Dim>&);       \
    template std::vector<Motion<Dim>> ledWhileGrowing<Dim>(const Motion<Dim>&, const Vec<Dim>&, double); \
    template std::vector<Motion<Dim>> ledGrowth<Dim>(const Motion<Dim>&, const Vec<Dim>&, double, double)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
