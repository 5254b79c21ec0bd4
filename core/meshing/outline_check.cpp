#include "core/meshing/outline_check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/mesh/segments.h"

namespace wend {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Loop = std::vector<Vec2>;

int side(const Vec2& a, const Vec2& b, const Vec2& p) {
    const auto exact = [](const Vec2& v) { return Kernel::Point_2(v.x(), v.y()); };
    return CGAL::orientation(exact(a), exact(b), exact(p));
}

std::string polygonName(std::size_t i) {
    return "polygon " + std::to_string(i) + " of the outline";
}

void requireFinite(const Loop& loop, std::size_t index) {
    for (std::size_t k = 0; k < loop.size(); ++k)
        if (!loop[k].allFinite())
            throw InputError("point " + std::to_string(k) + " of " + polygonName(index) + " is not finite");
}

Loop withoutRepeats(const Loop& loop) {
    Loop out;
    for (const auto& p : loop)
        if (out.empty() || out.back() != p) out.push_back(p);
    while (out.size() > 1 && out.back() == out.front()) out.pop_back();
    return out;
}

void requireArea(const Loop& loop, std::size_t index) {
    if (loop.size() < 3) throw InputError(polygonName(index) + " has fewer than 3 distinct points");
    for (const auto& p : loop)
        if (side(loop[0], loop[1], p) != 0) return;
    throw InputError(polygonName(index) + " has no area: all its points are on one line");
}

std::vector<Segment> segmentsOf(const Outline& outline) {
    std::vector<Segment> segments;
    for (const auto& loop : outline.loops)
        for (std::size_t k = 0; k < loop.size(); ++k)
            segments.push_back({loop[k], loop[(k + 1) % loop.size()]});
    return segments;
}

/// Returns the middle of the common part of two overlapping collinear segments.
std::optional<Vec2> overlap(const Segment& s, const Segment& t) {
    const auto less = [](const Vec2& p, const Vec2& q) {
        return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
    };
    const Vec2 from = std::max(std::min(s.a, s.b, less), std::min(t.a, t.b, less), less);
    const Vec2 to = std::min(std::max(s.a, s.b, less), std::max(t.a, t.b, less), less);
    if (!less(from, to)) return {};
    return Vec2((from + to) / 2);
}

Vec2 crossing(const Segment& s, const Segment& t) {
    const Vec2 u = s.b - s.a, v = t.b - t.a, w = t.a - s.a;
    const double det = u.x() * v.y() - u.y() * v.x();
    if (det == 0) return s.a;
    return s.a + u * ((w.x() * v.y() - w.y() * v.x()) / det);
}

/// Returns the place where segments share more than one touching point, if they do. The orientation tests are
/// exact; only the place itself is rounded.
std::optional<Vec2> conflict(const Segment& s, const Segment& t) {
    const int a = side(s.a, s.b, t.a), b = side(s.a, s.b, t.b);
    if (a == 0 && b == 0) return overlap(s, t);
    if (a * b >= 0) return {};
    if (side(t.a, t.b, s.a) * side(t.a, t.b, s.b) >= 0) return {};
    return crossing(s, t);
}

bool isOneOf(const Vec2& p, const std::vector<Vec2>& points) {
    return std::find(points.begin(), points.end(), p) != points.end();
}

/// Moves corners within the tolerance onto a point, unless they are points themselves.
bool moveCornersOnto(Outline& outline, const Vec2& p, const std::vector<Vec2>& points, double tolerance) {
    bool moved = false;
    for (auto& loop : outline.loops)
        for (auto& corner : loop) {
            if (corner != p && ((corner - p).norm() > tolerance || isOneOf(corner, points))) continue;
            corner = p;
            moved = true;
        }
    return moved;
}

/// Splits the nearest edge within the tolerance at a point.
void splitNearestEdge(Outline& outline, const Vec2& p, double tolerance) {
    double nearest = tolerance;
    Loop* where = nullptr;
    std::size_t after = 0;
    for (auto& loop : outline.loops)
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const double d = distanceToSegment<2>(p, loop[k], loop[(k + 1) % loop.size()]);
            if (d > nearest || (where && d == nearest)) continue;
            nearest = d;
            where = &loop;
            after = k;
        }
    if (where) where->insert(where->begin() + static_cast<std::ptrdiff_t>(after) + 1, p);
}

}  // namespace

Outline cleanedOutline(const Outline& outline) {
    if (outline.loops.empty()) throw InputError(sentence("Core", "the outline is empty"));
    Outline clean;
    for (std::size_t i = 0; i < outline.loops.size(); ++i) {
        requireFinite(outline.loops[i], i);
        clean.loops.push_back(withoutRepeats(outline.loops[i]));
        requireArea(clean.loops.back(), i);
    }
    return clean;
}

/// Finds pairs of segments whose boxes intersect, and tests them with exact predicates.
std::vector<SegmentCrossing> crossingsOf(const std::vector<Segment>& segments) {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;
    std::vector<Box> boxes;
    boxes.reserve(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const auto& [a, b] = segments[i];
        const CGAL::Bbox_2 bounds(std::min(a.x(), b.x()), std::min(a.y(), b.y()), std::max(a.x(), b.x()),
                                  std::max(a.y(), b.y()));
        boxes.emplace_back(bounds, static_cast<int>(i));
    }
    std::vector<SegmentCrossing> crossings;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& s, const Box& t) {
        const auto [first, second] = std::minmax({s.info(), t.info()});
        if (const auto place = conflict(segments[first], segments[second]))
            crossings.push_back({{first, second}, *place});
    });
    std::ranges::sort(crossings, {}, &SegmentCrossing::segments);
    return crossings;
}

void requireNoCrossing(const Outline& outline) {
    if (const auto crossings = crossingsOf(segmentsOf(outline)); !crossings.empty())
        throw InputError({sentence("Core", "the outline crosses or overlaps itself near %1"),
                          placeName<2>(crossings.front().place)});
}

Outline outlineThrough(Outline outline, const std::vector<Vec2>& points, double tolerance) {
    for (const auto& p : points)
        if (!moveCornersOnto(outline, p, points, tolerance)) splitNearestEdge(outline, p, tolerance);
    for (auto& loop : outline.loops) loop = withoutRepeats(loop);
    return outline;
}

}  // namespace wend
