#include "app/project/edits/offset_path.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/project/edits/bezier_edits.h"
#include "app/project/edits/progress.h"
#include "core/motion/curve.h"
#include "core/motion/easing.h"

namespace wend {

namespace {

constexpr int kSamples = 48;     // of a motion that is no polygon in time
constexpr double kApart = 1e-9;  // of a motion's duration, between its samples

/// Returns the offset of a recording at a fraction of its own time.
Vec3 offsetAt(const Recorded<3>& stroke, double s) {
    const double time = std::lerp(stroke.times.front(), stroke.times.back(), s);
    return OffsetPath{stroke.times, stroke.points}.at(time) - stroke.points.front();
}

/// Returns shares of a motion's duration at which it is sampled: even ones, that of a time, and those of the
/// corners, which are given as shares of the path.
std::set<double> sampleShares(const PinMotion& motion, double time, const std::vector<double>& corners) {
    std::set<double> shares = {0, 1};
    const auto add = [&](double s) {
        const auto after = shares.lower_bound(s);
        if (s > 0 && s < 1 && *after - s > kApart && s - *std::prev(after) > kApart) shares.insert(s);
    };
    add((time - motion.start) / (motion.end - motion.start));
    for (const double corner : corners) add(easeInverse(motion.ease, std::clamp(corner, 0.0, 1.0)));
    for (int i = 1; i < kSamples; ++i) add(double(i) / kSamples);
    return shares;
}

/// Returns a chain of cubics that is led as its parameter goes: it stays one, with its easing.
PinMotion ledChain(const PinMotion& motion, const Vec3& by, double first, double last, const Vec3& place) {
    PinMotion result = motion;
    auto& points = std::get<CurveMotion<3>>(result.kind).points;
    const Vec3 start = points.front();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(points.size() - 1);
        points[i] += place - start + (std::lerp(first, last, share) - first) * by;
    }
    return result;
}

}  // namespace

Vec3 OffsetPath::at(double time) const {
    const auto after = std::ranges::lower_bound(times, time) - times.begin();
    if (after == 0) return offsets.front();
    const auto i = std::min(static_cast<std::size_t>(after), times.size() - 1);
    const double part = (time - times[i - 1]) / (times[i] - times[i - 1]);
    return offsets[i - 1] + std::clamp(part, 0.0, 1.0) * (offsets[i] - offsets[i - 1]);
}

OffsetPath OffsetPath::led(const Vec3& by, double first, double last) const {
    OffsetPath result = *this;
    for (std::size_t i = 0; i < times.size(); ++i)
        result.offsets[i] +=
            by * std::lerp(first, last, (times[i] - times.front()) / (times.back() - times.front()));
    const Vec3 start = result.offsets.front();
    for (Vec3& offset : result.offsets) offset -= start;
    return result;
}

std::optional<OffsetPath> offsetPathOf(const PinMotion& motion, double time) {
    const auto timeAt = [&](double s) { return std::lerp(motion.start, motion.end, s); };
    OffsetPath path;
    const auto sample = [&](auto&& offset, const std::vector<double>& corners = {}) {
        for (const double s : sampleShares(motion, time, corners)) {
            path.times.push_back(timeAt(s));
            path.offsets.push_back(offset(ease(motion.ease, s)));
        }
    };
    const bool isEven = motion.ease == Ease::Linear;
    if (const auto* translate = std::get_if<Translate<3>>(&motion.kind)) {
        if (isEven)
            path = {{motion.start, motion.end}, {Vec3::Zero(), translate->by}};
        else
            sample([&](double u) { return Vec3(u * translate->by); });
        return path;
    }
    if (const auto* stroke = std::get_if<Recorded<3>>(&motion.kind)) {
        const double from = stroke->times.front(), length = stroke->times.back() - from;
        if (!isEven) {
            std::vector<double> corners;
            for (const double own : stroke->times) corners.push_back((own - from) / length);
            sample([&](double u) { return offsetAt(*stroke, u); }, corners);
            return path;
        }
        for (std::size_t i = 0; i < stroke->times.size(); ++i) {
            path.times.push_back(timeAt((stroke->times[i] - from) / length));
            path.offsets.push_back(stroke->points[i] - stroke->points.front());
        }
        return path;
    }
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    if (!curve || curve->frame != FrameKind::None || curve->scale != 1 || curve->twist != 0) return {};
    const Curve<3> line = curveOf(*curve);
    std::vector<double> corners;
    for (const CurvePiece<3>& piece : line.pieces) corners.push_back(piece.from);
    sample(
        [&](double u) {
            const int k = line.locate(u, 0, static_cast<int>(line.pieces.size()));
            return Vec3(line.pieces[k].value(line.pieces[k].local(u)) - line.pieces.front().value(0));
        },
        corners);
    return path;
}

std::optional<Vec3> offsetOf(const PinMotion& motion) {
    const auto path = offsetPathOf(motion, motion.end);
    return path ? std::optional(path->offsets.back()) : std::nullopt;
}

PinMotion motionAlong(const OffsetPath& path, const Vec3& place) {
    const double from = path.times.front(), length = path.times.back() - from;
    if (path.times.size() == 2)
        return {Translate<3>{path.offsets.back() - path.offsets.front()}, from, path.times.back()};
    Recorded<3> stroke;
    for (std::size_t i = 0; i < path.times.size(); ++i) {
        const bool isLast = i + 1 == path.times.size();
        const double s = isLast ? 1 : (path.times[i] - from) / length;
        if (i > 0 && !isLast && (s < stroke.times.back() + kApart || s > 1 - kApart)) continue;
        stroke.times.push_back(s);
        stroke.points.push_back(place + path.offsets[i]);
    }
    PinMotion motion;
    motion.kind = std::move(stroke);
    motion.start = from;
    motion.end = path.times.back();
    return motion;
}

std::pair<OffsetPath, OffsetPath> split(const OffsetPath& path, double time) {
    const Vec3 middle = path.at(time);
    std::pair<OffsetPath, OffsetPath> parts;
    parts.second = {{time}, {middle}};
    for (std::size_t i = 0; i < path.times.size(); ++i) {
        OffsetPath& part = path.times[i] < time ? parts.first : parts.second;
        if (path.times[i] == time) continue;
        part.times.push_back(path.times[i]);
        part.offsets.push_back(path.offsets[i]);
    }
    parts.first.times.push_back(time);
    parts.first.offsets.push_back(middle);
    return parts;
}

std::optional<PinMotion> led(const PinMotion& motion, const Vec3& by, double first, double last,
                             const Vec3& place) {
    if (const auto* straight = std::get_if<Translate<3>>(&motion.kind)) {
        PinMotion result = motion;
        result.kind = Translate<3>{straight->by + (last - first) * by};
        return result;
    }
    if (straightProgress(motion)) {
        const auto& points = std::get<CurveMotion<3>>(motion.kind).points;
        const Vec3 way = points.back() - points.front() + (last - first) * by;
        return straightMove(way, {motion.start, motion.end}, *straightProgress(motion), place);
    }
    const auto* chain = std::get_if<CurveMotion<3>>(&motion.kind);
    const auto path = offsetPathOf(motion, motion.end);
    if (path && chain && chain->interpolation == Interpolation::Bezier)
        return ledChain(motion, by, first, last, place);
    return path ? std::optional(motionAlong(path->led(by, first, last), place)) : std::nullopt;
}

}  // namespace wend
