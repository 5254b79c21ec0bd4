#include "core/meshing/surface_check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/error.h"
#include "core/meshing/surface_edges.h"
#include "core/meshing/touching_bodies.h"

namespace wend {
namespace {

using CrossingKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CrossingPoint = CrossingKernel::Point_3;
using Ids = std::array<int, 3>;

bool indicesGood(const Surface& surface, const Ids& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](int id) { return id >= 0 && id < surface.vertexCount(); });
}

Ids sortedIds(Ids ids) {
    std::sort(ids.begin(), ids.end());
    return ids;
}

/// Exact tests of triangles with merged vertices.
class Crossing {
  public:
    explicit Crossing(const Points3& points) : m_points(points) {}

    CrossingPoint point(int id) const { return {m_points(0, id), m_points(1, id), m_points(2, id)}; }
    bool flat(const Ids& t) const { return CGAL::collinear(point(t[0]), point(t[1]), point(t[2])); }

    bool operator()(Ids a, Ids b) const {
        const int shared = sharedFirst(a, b);
        if (shared >= 3) return false;  // a duplicate
        if (shared == 2) return foldedOnto(a, b);
        if (shared == 1)
            return CGAL::do_intersect(segment(a[1], a[2]), triangle(b)) ||
                   CGAL::do_intersect(segment(b[1], b[2]), triangle(a));
        return CGAL::do_intersect(triangle(a), triangle(b));
    }

  private:
    CrossingKernel::Triangle_3 triangle(const Ids& t) const {
        return {point(t[0]), point(t[1]), point(t[2])};
    }
    CrossingKernel::Segment_3 segment(int a, int b) const { return {point(a), point(b)}; }

    /// Brings the shared vertices to the front of both, in one order; returns their number.
    static int sharedFirst(Ids& a, Ids& b) {
        int shared = 0;
        for (int i = 0; i < 3; ++i) {
            const auto at = std::find(b.begin() + shared, b.end(), a[i]);
            if (at == b.end()) continue;
            std::swap(a[i], a[shared]);
            std::iter_swap(at, b.begin() + shared);
            ++shared;
        }
        return shared;
    }

    /// Returns whether two triangles with a common edge are coplanar and on the same side of it.
    bool foldedOnto(const Ids& a, const Ids& b) const {
        const CrossingPoint p = point(a[0]), q = point(a[1]), r = point(a[2]), s = point(b[2]);
        return CGAL::orientation(p, q, r, s) == CGAL::COPLANAR &&
               CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
    }

    const Points3& m_points;
};

/// There may be millions of crossings, so the search stops when enough are found.
void findCrossings(const Surface& surface, const std::vector<Ids>& canonical, const std::vector<bool>& usable,
                   int limit, const std::stop_token& stop, SurfaceProblems& problems) {
    struct Enough {};
    using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, std::vector<Ids>::const_iterator>;
    const Crossing crosses(surface.points);
    std::vector<Box> boxes;
    for (auto it = canonical.begin(); it != canonical.end(); ++it) {
        if (!usable[it - canonical.begin()]) continue;
        CGAL::Bbox_3 box;
        for (int id : *it) box += crosses.point(id).bbox();
        boxes.emplace_back(box, it);
    }
    const auto index = [&](const Box& box) { return static_cast<int>(box.handle() - canonical.begin()); };
    const auto report = [&](const Box& a, const Box& b) {
        if (stop.stop_requested()) throw Cancelled();
        if (!crosses(*a.handle(), *b.handle())) return;
        const int i = index(a), j = index(b);
        problems.intersecting.push_back({std::min(i, j), std::max(i, j)});
        if (static_cast<int>(problems.intersecting.size()) >= limit) throw Enough();
    };
    try {
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), report);
    } catch (const Enough&) {
    }
    std::sort(problems.intersecting.begin(), problems.intersecting.end());
}

/// Finds triangles that are invalid, degenerate or duplicate, and marks all others as usable.
void sortOutTriangles(const Surface& surface, const std::vector<int>& canonicalId,
                      std::vector<Ids>& canonical, std::vector<bool>& usable, SurfaceProblems& problems) {
    const Crossing geometry(surface.points);
    std::map<Ids, int> known;  // the first triangle at a place
    std::map<Ids, bool> alreadyFaced;
    for (int t = 0; t < surface.triangleCount(); ++t) {
        const Ids& triangle = surface.triangles[t];
        if (!indicesGood(surface, triangle)) {
            problems.badIndex.push_back(t);
            continue;
        }
        Ids& ids = canonical[t];
        std::transform(triangle.begin(), triangle.end(), ids.begin(),
                       [&](int id) { return canonicalId[id]; });
        const bool finite =
            std::all_of(ids.begin(), ids.end(), [&](int id) { return surface.points.col(id).allFinite(); });
        if (!finite) continue;
        if (ids[0] == ids[1] || ids[1] == ids[2] || ids[0] == ids[2] || geometry.flat(ids))
            problems.degenerate.push_back(t);
        else if (const auto [first, isNew] = known.try_emplace(sortedIds(ids), t); isNew)
            usable[t] = true;
        else if (const Ids& one = canonical[first->second];
                 !runsAlong(ids, one[0], one[1]) && !std::exchange(alreadyFaced[first->first], true))
            problems.shared.push_back(t);
        else
            problems.duplicate.push_back(t);
    }
}

/// Finds edges of one triangle, of more than two, and of two that run in the same direction.
void checkEdges(const Surface& surface, const std::vector<Ids>& canonical, const std::vector<bool>& usable,
                SurfaceProblems& problems) {
    Surface clean{surface.points, {}, {}};
    for (std::size_t t = 0; t < canonical.size(); ++t)
        if (usable[t]) clean.triangles.push_back(canonical[t]);
    const auto forward = [&](int t, const std::array<int, 2>& edge) {
        return runsAlong(clean.triangles[t], edge[0], edge[1]);
    };
    for (const auto& edge : edgesOf(clean)) {
        if (edge.triangles.size() == 1)
            problems.openEdges.push_back(edge.vertices);
        else if (edge.triangles.size() > 2)
            problems.nonManifoldEdges.push_back(edge.vertices);
        else if (forward(edge.triangles[0], edge.vertices) == forward(edge.triangles[1], edge.vertices))
            problems.misoriented.push_back(edge.vertices);
    }
}

/// Returns whether all points are in one plane, by exact predicates.
bool liesInAPlane(const Surface& surface) {
    const int count = surface.vertexCount();
    if (count < 4) return true;
    const Crossing geometry(surface.points);
    int second = 1;
    while (second < count && geometry.point(second) == geometry.point(0)) ++second;
    int third = second + 1;
    while (third < count && CGAL::collinear(geometry.point(0), geometry.point(second), geometry.point(third)))
        ++third;
    for (int i = third + 1; i < count; ++i)
        if (!CGAL::coplanar(geometry.point(0), geometry.point(second), geometry.point(third),
                            geometry.point(i)))
            return false;
    return true;
}

}  // namespace

bool runsAlong(const Ids& triangle, int from, int to) {
    for (int k = 0; k < 3; ++k)
        if (triangle[k] == from && triangle[(k + 1) % 3] == to) return true;
    return false;
}

std::array<int, 2> sorted(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

std::vector<std::array<int, 2>> sidesOf(const std::vector<int>& loop) {
    std::vector<std::array<int, 2>> sides;
    for (std::size_t k = 0; k < loop.size(); ++k)
        sides.push_back(sorted(loop[k], loop[(k + 1) % loop.size()]));
    return sides;
}

std::vector<SurfaceEdge> edgesOf(const Surface& surface) {
    struct Side {
        std::array<int, 2> edge;
        int triangle;
    };
    std::vector<Side> sides;
    for (int t = 0; t < surface.triangleCount(); ++t) {
        const Ids& ids = surface.triangles[t];
        if (!indicesGood(surface, ids)) continue;
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(ids[k], ids[(k + 1) % 3]);
            sides.push_back({{low, high}, t});
        }
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.edge < b.edge; });
    std::vector<SurfaceEdge> edges;
    for (const Side& side : sides) {
        if (edges.empty() || edges.back().vertices != side.edge) edges.push_back({side.edge, {}});
        edges.back().triangles.push_back(side.triangle);
    }
    return edges;
}

std::vector<int> canonicalVertices(const Points3& points) {
    std::vector<int> order(static_cast<std::size_t>(points.cols()));
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int i) { return std::array{points(0, i), points(1, i), points(2, i)}; };
    std::vector<int> finite;
    std::copy_if(order.begin(), order.end(), std::back_inserter(finite),
                 [&](int i) { return points.col(i).allFinite(); });
    std::stable_sort(finite.begin(), finite.end(), [&](int a, int b) { return key(a) < key(b); });
    std::vector<int> canonical = order;
    for (std::size_t i = 1; i < finite.size(); ++i)
        if (key(finite[i]) == key(finite[i - 1])) canonical[finite[i]] = canonical[finite[i - 1]];
    return canonical;
}

SurfaceProblems checkSurface(const Surface& surface, int limit, const std::stop_token& stop) {
    SurfaceProblems problems;
    for (int i = 0; i < surface.vertexCount(); ++i)
        if (!surface.points.col(i).allFinite()) problems.notFinite.push_back(i);
    const std::vector<int> canonicalId = canonicalVertices(surface.points);
    for (int i = 0; i < surface.vertexCount(); ++i) problems.coincidentVertices += canonicalId[i] != i;
    std::vector<Ids> canonical(surface.triangles.size());
    std::vector<bool> usable(surface.triangles.size(), false);
    sortOutTriangles(surface, canonicalId, canonical, usable, problems);
    if (!problems.notFinite.empty()) return problems;
    problems.flat = liesInAPlane(surface);
    checkEdges(surface, canonical, usable, problems);
    if (limit > 0) findCrossings(surface, canonical, usable, limit, stop, problems);
    problems.touching = touchingBodies(surface, problems.intersecting);
    return problems;
}

SurfaceProblems checkSurface(const Surface& surface, int limit) {
    return checkSurface(surface, limit, {});
}

}  // namespace wend
