#include "app/project/edits/grown_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/project/edits/bezier_edits.h"
#include "app/project/edits/offset_path.h"
#include "app/project/edits/progress.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr double kJoint = 1e-9;  // part of a piece that is not divided off

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
    if (motion.ease != Ease::Linear) return {};
    if (const auto* curve = growthOf<Dim>(motion)) return growthThrough<Dim>(motion, *curve, by, time);
    const auto* field = std::get_if<FieldMotion<Dim>>(&motion.kind);
    if (!field) return {};
    const double share = (time - motion.start) / (motion.end - motion.start);
    return {{scaledField<Dim>(*field, share, by), motion.start, time},
            {scaledField<Dim>(*field, 1 - share, -by), time, motion.end}};
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

template <int Dim>
std::optional<Motion<Dim>> joinedGrowth(const Motion<Dim>& before, const Motion<Dim>& after) {
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
