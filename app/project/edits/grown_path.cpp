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
const CurveMotion<3>* growthOf(const PinMotion& motion) {
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    const bool grows = curve && curve->scale != 1 && curve->frame == FrameKind::None && curve->twist == 0;
    return grows ? curve : nullptr;
}

/// Returns the cubics of an even growth's path, which are absolute.
std::vector<TimedCubic> pathOf(const PinMotion& motion, const CurveMotion<3>& curve) {
    PinMotion path = motion;
    path.ease = Ease::Linear;
    auto& plain = std::get<CurveMotion<3>>(path.kind);
    plain.scale = 1;
    if (curve.interpolation == Interpolation::Polyline && curve.points.size() == 2) {  // as a cubic
        const Vec3 &from = curve.points[0], &to = curve.points[1];
        plain.points = {from, from + (to - from) / 3, from + 2 * (to - from) / 3, to};
        plain.interpolation = Interpolation::Bezier;
    }
    auto pieces = cubicsOf(path);
    for (TimedCubic& piece : pieces)
        for (Vec3& point : piece.points) point += curve.points.front();
    return pieces;
}

/// Divides the piece that holds the time there, unless it begins or ends then.
void divide(std::vector<TimedCubic>& pieces, double time) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const TimedCubic own = pieces[i];
        const double share = (time - own.time.start) / (own.time.end - own.time.start);
        if (share < kJoint || share > 1 - kJoint) continue;
        const std::vector<Vec3> both = splitBezier({own.points.begin(), own.points.end()}, 0, share);
        pieces[i] = {{both[0], both[1], both[2], both[3]}, {own.time.start, time}};
        pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                      {{both[3], both[4], both[5], both[6]}, {time, own.time.end}});
        return;
    }
}

std::vector<PinMotion> growthThrough(const PinMotion& motion, const CurveMotion<3>& curve, const Vec3& by,
                                     double time) {
    auto pieces = pathOf(motion, curve);
    divide(pieces, time);
    const auto scaleAt = [&](double t) {
        return std::lerp(1.0, curve.scale, (t - motion.start) / (motion.end - motion.start));
    };
    std::vector<PinMotion> result;
    for (const TimedCubic& piece : pieces) {
        CurveMotion<3> part;
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
void easeAs(const PinMotion& whole, double even, double time, std::vector<PinMotion>& parts) {
    if (whole.ease == Ease::Linear) return;
    const double length = whole.end - whole.start;
    const auto timeOf = [&](double t) {
        if (t == even) return time;
        const double share = (t - whole.start) / length;
        return share >= 1 ? whole.end : whole.start + easeInverse(whole.ease, share) * length;
    };
    for (PinMotion& part : parts) {
        part.start = timeOf(part.start);
        part.end = timeOf(part.end);
        part.ease =
            nearestEase(whole.ease, (part.start - whole.start) / length, (part.end - whole.start) / length);
    }
}

/// Returns the displacements times a factor, plus a common one.
FieldMotion<3> scaledField(const FieldMotion<3>& field, double factor, const Vec3& by) {
    auto values = *field.values;
    for (auto& [vertex, displacement] : values) displacement = factor * displacement + by;
    FieldMotion<3> result;
    result.values = std::make_shared<const Displacements<3>>(std::move(values));
    return result;
}

}  // namespace

std::vector<PinMotion> ledWhileGrowing(const PinMotion& motion, const Vec3& by, double time) {
    const double length = motion.end - motion.start,
                 share = ease(motion.ease, (time - motion.start) / length);
    const double even = motion.ease == Ease::Linear ? time : motion.start + share * length;
    std::vector<PinMotion> parts;
    if (const auto* curve = growthOf(motion)) {
        parts = growthThrough(motion, *curve, by, even);
    } else if (const auto* field = std::get_if<FieldMotion<3>>(&motion.kind)) {
        parts = {{scaledField(*field, share, by), motion.start, even},
                 {scaledField(*field, 1 - share, -by), even, motion.end}};
    }
    easeAs(motion, even, time, parts);
    return parts;
}

std::vector<PinMotion> ledGrowth(const PinMotion& motion, const Vec3& by, double first, double last) {
    PinMotion result = motion;
    if (const auto* field = std::get_if<FieldMotion<3>>(&motion.kind)) {
        result.kind = scaledField(*field, 1, (last - first) * by);
        return {result};
    }
    const auto* curve = growthOf(motion);
    if (!curve || curve->interpolation != Interpolation::Bezier) return {};
    auto& points = std::get<CurveMotion<3>>(result.kind).points;
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] +=
            std::lerp(first, last, static_cast<double>(i) / static_cast<double>(points.size() - 1)) * by;
    return {result};
}

/// Returns the field of displacements of two motions that follow each other, of which one at least is a field
/// and the other a field or a translation.
std::optional<PinMotion> joinedFields(const PinMotion& before, const PinMotion& after) {
    std::map<int, Vec3> sum;
    const auto *one = std::get_if<FieldMotion<3>>(&before.kind),
               *two = std::get_if<FieldMotion<3>>(&after.kind);
    const auto first = offsetOf(before), second = offsetOf(after);
    if (!(one || two) || !(one || first) || !(two || second)) return {};
    for (const auto* field : {one, two})
        if (field)
            for (const auto& [vertex, displacement] : *field->values)
                sum.try_emplace(vertex, Vec3::Zero()).first->second += displacement;
    if (!one || !two)
        for (auto& [vertex, displacement] : sum) displacement += one ? *second : *first;
    FieldMotion<3> whole;
    whole.values = std::make_shared<const Displacements<3>>(sum.begin(), sum.end());
    return PinMotion{std::move(whole), before.start, after.end};
}

std::optional<PinMotion> joinedGrowth(const PinMotion& before, const PinMotion& after) {
    if (auto fields = joinedFields(before, after)) return fields;
    const auto *one = growthOf(before), *two = growthOf(after);
    if ((!one && !offsetOf(before)) || (!two && !offsetOf(after)) || !(one || two)) return {};
    const auto first = Trajectory<3>(before).at(before.end, Side::Before).position,
               second = Trajectory<3>(after).at(after.end, Side::Before).position;
    const Vec3 from = (one ? one : two)->points.front(), to = second(first(from));
    CurveMotion<3> whole;
    whole.points = {from, from + (to - from) / 3, from + 2 * (to - from) / 3, to};
    whole.scale = (one ? one->scale : 1) * (two ? two->scale : 1);
    return PinMotion{std::move(whole), before.start, after.end};
}

}  // namespace wend
