#include "app/project/edits/film_time.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <set>

#include "app/project/edits/bezier_edits.h"
#include "app/project/edits/handle_comparison.h"
#include "app/project/edits/progress.h"
#include "app/project/project.h"
#include "core/motion/easing.h"
#include "core/motion/screw_motion.h"

namespace wend {

namespace {

constexpr int kCurveSamples = 64;

double lengthOf(const std::vector<Vec3>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    return length;
}

double lengthOf(const Translate<3>& motion, double) {
    return motion.by.norm();
}
double lengthOf(const Rotate<3>& motion, double arm) {
    return std::abs(motion.angle) * arm;
}
double lengthOf(const Recorded<3>& motion, double) {
    return lengthOf(motion.points);
}
double lengthOf(const CurveMotion<3>& motion, double arm) {
    std::vector<Vec3> line;
    for (const CurvePiece<3>& piece : curveOf(motion).pieces)
        for (int i = 0; i <= kCurveSamples; ++i) line.push_back(piece.value(double(i) / kCurveSamples));
    return lengthOf(line) + arm * (std::abs(motion.scale - 1) + std::abs(motion.twist));
}

double lengthOf(const FieldMotion<3>& motion, double) {
    double longest = 0;
    for (const auto& [vertex, displacement] : *motion.values)
        longest = std::max(longest, displacement.norm());
    return longest;
}
double lengthOf(const PoseMotion<3>& motion, double arm) {
    double length = 0;
    for (std::size_t i = 1; i < motion.poses.size(); ++i) {
        const RigidPose<3>&from = motion.poses[i - 1], &to = motion.poses[i];
        length += (to.position - from.position).norm() + arm * (to.rotation - from.rotation).norm();
    }
    return length;
}

/// Returns the mean distance of the points from their centroid.
double armOf(const std::vector<Vec3>& points) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
    double sum = 0;
    for (const Vec3& p : points) sum += (p - middle).norm();
    return sum / static_cast<double>(points.size());
}

/// Returns the lever arm of a handle's rotation and scaling: half the size of its region.
double armOf(const Pin& handle, double arm) {
    if (const auto* points = std::get_if<std::vector<Vec3>>(&handle.at)) return armOf(*points);
    const auto* region = std::get_if<Region<3>>(&handle.at);
    if (!region) return arm;
    if (const auto* ball = std::get_if<Ball<3>>(region)) return ball->radius;
    if (const auto* box = std::get_if<Box<3>>(region)) return (box->max - box->min).norm() / 2;
    const auto* polygon = std::get_if<Polygon>(region);
    if (!polygon) return arm;
    Vec2 low = polygon->points.front(), high = low;
    for (const Vec2& p : polygon->points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    return (high - low).norm() / 2;
}

/// Returns the share of a motion's duration, and so of its path, between two times.
double shareOf(const PinMotion& motion, double from, double to) {
    const double common = std::min(motion.end, to) - std::max(motion.start, from);
    return std::max(common, 0.0) / (motion.end - motion.start);
}

Translate<3> upTo(const Translate<3>& motion, double u) {
    return {u * motion.by};
}
Rotate<3> upTo(Rotate<3> motion, double u) {
    motion.angle *= u;
    return motion;
}
Recorded<3> upTo(const Recorded<3>& motion, double u) {
    const double end = motion.times.front() + u * (motion.times.back() - motion.times.front());
    Recorded<3> result;
    std::size_t i = 0;
    for (; i < motion.times.size() && motion.times[i] < end; ++i) {
        result.times.push_back(motion.times[i]);
        result.points.push_back(motion.points[i]);
    }
    if (i == 0 || i == motion.times.size()) return motion;
    const double v = (end - motion.times[i - 1]) / (motion.times[i] - motion.times[i - 1]);
    result.times.push_back(end);
    result.points.push_back((1 - v) * motion.points[i - 1] + v * motion.points[i]);
    return result;
}

/// Returns the part of the motion up to u. Its values differ from those of the file, which is named no more.
FieldMotion<3> upTo(const FieldMotion<3>& motion, double u) {
    auto values = std::make_shared<Displacements<3>>(*motion.values);
    for (auto& [vertex, displacement] : *values) displacement *= u;
    return {"", "", std::move(values)};
}
PoseMotion<3> upTo(const PoseMotion<3>& motion, double u) {
    const double end = motion.times.front() + u * (motion.times.back() - motion.times.front());
    PoseMotion<3> result;
    std::size_t i = 0;
    for (; i < motion.times.size() && motion.times[i] < end; ++i) {
        result.times.push_back(motion.times[i]);
        result.poses.push_back(motion.poses[i]);
    }
    if (i == 0 || i == motion.times.size()) return motion;
    const double s = (end - motion.times[i - 1]) / (motion.times[i] - motion.times[i - 1]);
    result.times.push_back(end);
    result.poses.push_back(poseBetween<3>(motion.poses[i - 1], motion.poses[i], s));
    return result;
}

/// Returns the control points of a chain of the same cubics: a spline that ended early would be another
/// spline.
std::vector<Vec3> bezierPoints(const Curve<3>& curve) {
    std::vector<Vec3> points = {curve.pieces.front().value(0)};
    for (const CurvePiece<3>& piece : curve.pieces) {
        const auto& c = piece.coefficients;
        points.push_back(c.col(0) + c.col(1) / 3);
        points.push_back(c.col(0) + c.col(1) * 2 / 3 + c.col(2) / 3);
        points.push_back(piece.value(1));
    }
    return points;
}

CurveMotion<3> upTo(const CurveMotion<3>& motion, double u) {
    const Curve<3> curve = curveOf(motion);
    const int k = curve.locate(u, 0, static_cast<int>(curve.pieces.size()));
    const double v = curve.pieces[k].local(u);
    CurveMotion<3> result = motion;
    result.scale = 1 + u * (motion.scale - 1);
    result.twist = u * motion.twist;
    if (motion.interpolation == Interpolation::Polyline) {
        result.points.clear();
        for (int i = 0; i <= k; ++i) result.points.push_back(curve.pieces[i].value(0));
        result.points.push_back(curve.pieces[k].value(v));
        return result;
    }
    result.interpolation = Interpolation::Bezier;
    result.points = splitBezier(bezierPoints(curve), k, v);
    result.points.resize(3 * k + 4);
    return result;
}

/// Cuts a motion at a time. A cut easing is none of the four, so only `in` is kept.
PinMotion endedAt(const PinMotion& motion, double time) {
    const double u = ease(motion.ease, (time - motion.start) / (motion.end - motion.start));
    PinMotion result = motion;
    result.end = time;
    if (motion.ease != Ease::In) result.ease = Ease::Linear;
    using Kind = decltype(result.kind);
    result.kind = std::visit([u](const auto& kind) -> Kind { return upTo(kind, std::clamp(u, 0.0, 1.0)); },
                             motion.kind);
    return result;
}

/// Compares times without rounding: nearly equal times count as equal.
bool isAfter(double a, double b) {
    return a > b && !sameTime(a, b);
}

/// Returns how far a recorded rhythm is from uniform speed, as fractions of time and path.
double unevenness(const PinMotion& motion) {
    const auto* stroke = std::get_if<Recorded<3>>(&motion.kind);
    if (!stroke) return 0;
    const double whole = lengthOf(stroke->points), time = stroke->times.back() - stroke->times.front();
    double length = 0, worst = 0;
    for (std::size_t i = 1; i < stroke->points.size() && whole > 0; ++i) {
        length += (stroke->points[i] - stroke->points[i - 1]).norm();
        worst = std::max(worst, std::abs(length / whole - (stroke->times[i] - stroke->times.front()) / time));
    }
    return worst;
}

/// An interval in which motions run together.
struct Stretch {
    double start = 0, end = 0, pace = 0;
    auto operator<=>(const Stretch&) const = default;
};

/// Returns the intervals in order of their starts. Relaxations have no pace.
std::vector<Stretch> stretchesOf(const Project& project) {
    std::vector<Stretch> stretches;
    for (const SettleWindow& window : project.settle) stretches.push_back({window.start, window.end});
    for (const Pin& handle : project.design.handles)
        for (const PinMotion& motion : handle.motions) {
            const auto same = std::ranges::find_if(stretches, [&motion](const Stretch& one) {
                return sameTime(one.start, motion.start) && sameTime(one.end, motion.end);
            });
            Stretch& own =
                same != stretches.end() ? *same : stretches.emplace_back(Stretch{motion.start, motion.end});
            own.pace = std::max(own.pace, pathLength(motion, 0) / (motion.end - motion.start));
        }
    std::ranges::sort(stretches);
    return stretches;
}

}  // namespace

bool hasOwnTiming(const Project& project) {
    constexpr double kSeen = 0.02;  // of the film, or of a motion
    constexpr double kUnlike = 3;   // times as fast
    bool movesOnly = true;
    for (const Pin& handle : project.design.handles)
        for (const PinMotion& motion : handle.motions) {
            if (motion.ease != Ease::Linear || unevenness(motion) > kSeen) return true;
            if (const auto own = straightProgress(motion); own && !easeOf(*own)) return true;
            movesOnly = movesOnly && std::holds_alternative<Recorded<3>>(motion.kind);
        }
    double at = 0, slowest = std::numeric_limits<double>::infinity(), fastest = 0;
    for (const Stretch& one : stretchesOf(project)) {
        if (std::abs(one.start - at) > kSeen * project.end) return true;
        at = one.end;
        // Such short intervals may have been lengthened to the minimum.
        if (one.pace == 0 || one.end - one.start < kSeen * project.end) continue;
        slowest = std::min(slowest, one.pace);
        fastest = std::max(fastest, one.pace);
    }
    return at > 0 && (project.end - at > kSeen * project.end || (movesOnly && fastest > kUnlike * slowest));
}

namespace {

/// Calls `map` for every time of the project but its end.
template <class Map>
void mapTimes(Project& project, const Map& map) {
    for (Pin& handle : project.design.handles) {
        for (PinMotion& motion : handle.motions)
            motion.start = map(motion.start), motion.end = map(motion.end);
        handle.activeFrom = map(handle.activeFrom);
        handle.activeTo = map(handle.activeTo);
    }
    for (SettleWindow& window : project.settle) window = {map(window.start), map(window.end)};
    for (TimeMarker& marker : project.markers) marker.at = map(marker.at);
    if (project.cycle) project.cycle = {map(project.cycle->at(0)), map(project.cycle->at(1))};
}

}  // namespace

double pathLength(const PinMotion& motion, double arm) {
    return std::visit([arm](const auto& kind) { return lengthOf(kind, arm); }, motion.kind);
}

double pathLength(const std::vector<Pin>& handles, double arm) {
    std::set<double> breakpoints;
    for (const Pin& handle : handles)
        for (const PinMotion& motion : handle.motions) breakpoints.insert({motion.start, motion.end});
    std::vector<double> longest(breakpoints.size(), 0.0);
    for (const Pin& handle : handles)
        for (const PinMotion& motion : handle.motions) {
            const double length = pathLength(motion, armOf(handle, arm));
            std::size_t i = 0;
            for (auto to = breakpoints.begin(); to != breakpoints.end() && ++to != breakpoints.end(); ++i) {
                const double share = shareOf(motion, *std::prev(to), *to);
                longest[i] = std::max(longest[i], share * length);
            }
        }
    double sum = 0;
    for (const double length : longest) sum += length;
    return sum;
}

void endMotionsAt(Pin& handle, double time) {
    std::erase_if(handle.motions, [time](const PinMotion& motion) {
        return motion.start >= time || sameTime(motion.start, time);
    });
    for (PinMotion& motion : handle.motions) {
        if (isAfter(motion.end, time)) motion = endedAt(motion, time);
        motion.end = std::min(motion.end, time);
    }
}

Project endedAt(const Project& project, double time) {
    Project next = project;
    for (Pin& handle : next.design.handles) {
        endMotionsAt(handle, time);
        const double never = std::numeric_limits<double>::infinity();
        handle.activeFrom =
            isAfter(handle.activeFrom, time) ? project.end : std::min(handle.activeFrom, time);
        handle.activeTo = isAfter(handle.activeTo, time) ? never : std::min(handle.activeTo, time);
    }
    std::erase_if(next.settle,
                  [time](const SettleWindow& w) { return w.start >= time || sameTime(w.start, time); });
    for (SettleWindow& window : next.settle) window.end = std::min(window.end, time);
    return next;
}

Project withTimesMoved(Project project, double from, double to) {
    const double end = project.end;
    const bool whole = from >= end;
    mapTimes(project, [=](double t) {
        if (whole || t <= from) return t == from ? to : t * (to / from);
        return t >= end ? t : end - (end - t) * ((end - to) / (end - from));
    });
    return project;
}

Project withLength(Project project, double length) {
    const double before = project.end;
    mapTimes(project, [=](double t) { return t == before ? length : t * (length / before); });
    project.end = length;
    return project;
}

}  // namespace wend
