#include "core/meshing/surface_facts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/disjoint_sets.h"
#include "core/meshing/solid_angle.h"
#include "core/meshing/surface_edges.h"

namespace wend {
namespace {

/// Merges vertices, and removes triangles that repeat a vertex or another triangle.
Surface cleaned(const Surface& surface) {
    const std::vector<int> first = canonicalVertices(surface.points);
    Surface clean{surface.points, {}, {}};
    std::map<std::array<int, 3>, int> known;
    for (auto t : surface.triangles) {
        for (int& v : t) v = first[v];
        auto key = t;
        std::ranges::sort(key);
        if (std::ranges::adjacent_find(key) == key.end() && known.emplace(key, 0).second)
            clean.triangles.push_back(t);
    }
    return clean;
}

/// Groups the corners of all triangles around vertices: where fans meet in a point only, each has a vertex of
/// its own.
class Corners {
  public:
    Corners(const Surface& surface, const std::vector<SurfaceEdge>& edges)
        : m_surface(surface), m_sets(3 * surface.triangleCount()) {
        for (const SurfaceEdge& edge : edges)
            if (edge.triangles.size() == 2)
                for (const int v : edge.vertices)
                    m_sets.join(corner(edge.triangles[0], v), corner(edge.triangles[1], v));
    }
    int at(int triangle, int vertex) { return m_sets.root(corner(triangle, vertex)); }
    int count() {
        int roots = 0;
        for (int i = 0; i < 3 * m_surface.triangleCount(); ++i) roots += m_sets.root(i) == i;
        return roots;
    }

  private:
    int corner(int triangle, int vertex) const {
        const auto& t = m_surface.triangles[triangle];
        return 3 * triangle + static_cast<int>(std::ranges::find(t, vertex) - t.begin());
    }

    const Surface& m_surface;
    DisjointSets m_sets;
};

int countSets(DisjointSets& sets, const std::vector<bool>& of) {
    int count = 0;
    for (std::size_t i = 0; i < of.size(); ++i)
        count += of[i] && sets.root(static_cast<int>(i)) == static_cast<int>(i);
    return count;
}

/// Triangles that are connected through edges.
struct Part {
    std::vector<int> triangles;
    Eigen::AlignedBox3d box;
};

/// Returns the parts that are connected through edges, with their boxes.
std::vector<Part> partsOf(const Surface& surface, const std::vector<SurfaceEdge>& edges) {
    DisjointSets sets(surface.triangleCount());
    for (const SurfaceEdge& edge : edges)
        for (const int t : edge.triangles) sets.join(t, edge.triangles[0]);
    std::map<int, Part> byRoot;
    for (int t = 0; t < surface.triangleCount(); ++t) {
        Part& part = byRoot[sets.root(t)];
        part.triangles.push_back(t);
        for (const int v : surface.triangles[t]) part.box.extend(surface.points.col(v).eval());
    }
    std::vector<Part> parts;
    for (auto& [root, part] : byRoot) parts.push_back(std::move(part));
    return parts;
}

/// Returns the signed volume of a part, relative to the middle of its box.
double signedVolume(const Surface& surface, const Part& part) {
    double volume = 0;
    const Vec3 origin = part.box.center();
    for (const int t : part.triangles) {
        const auto& ids = surface.triangles[t];
        const Vec3 a = surface.points.col(ids[0]) - origin, b = surface.points.col(ids[1]) - origin,
                   c = surface.points.col(ids[2]) - origin;
        volume += a.dot(b.cross(c)) / 6;
    }
    return volume;
}

/// Returns whether a part encloses p: the sum of the solid angles of its triangles is then an odd multiple of
/// 4π. Assumes closed parts that do not cross, with any orientation.
bool encloses(const Surface& surface, const Part& part, const Vec3& p) {
    if (!part.box.contains(p)) return false;
    double angle = 0;
    for (const int t : part.triangles) {
        const auto& ids = surface.triangles[t];
        angle +=
            solidAngle(p, surface.points.col(ids[0]), surface.points.col(ids[1]), surface.points.col(ids[2]));
    }
    return std::lround(std::abs(angle) / (4 * std::numbers::pi)) % 2 == 1;
}

/// Returns the volume between the parts, and counts how deep they are nested.
double enclosedVolume(const Surface& surface, const std::vector<Part>& parts, int& deepest) {
    double volume = 0;
    for (const Part& part : parts) {
        const auto& first = surface.triangles[part.triangles[0]];
        const Vec3 p =
            (surface.points.col(first[0]) + surface.points.col(first[1]) + surface.points.col(first[2])) / 3;
        const auto around = std::ranges::count_if(
            parts, [&](const Part& other) { return &other != &part && encloses(surface, other, p); });
        volume += (around % 2 == 0 ? 1 : -1) * std::abs(signedVolume(surface, part));
        deepest = std::max(deepest, static_cast<int>(around) + 1);
    }
    return volume;
}

/// Counts the boundary loops, by joining the corners of triangles along open edges.
int loopsOf(const Surface& surface, const std::vector<SurfaceEdge>& edges, Corners& corners) {
    DisjointSets sets(3 * surface.triangleCount());
    std::vector<bool> onBoundary(3 * surface.triangles.size(), false);
    for (const SurfaceEdge& edge : edges) {
        if (edge.triangles.size() != 1) continue;
        const int a = corners.at(edge.triangles[0], edge.vertices[0]),
                  b = corners.at(edge.triangles[0], edge.vertices[1]);
        sets.join(a, b);
        onBoundary[a] = onBoundary[b] = true;
    }
    return countSets(sets, onBoundary);
}

bool isOriented(const Surface& surface, const std::vector<SurfaceEdge>& edges) {
    return std::ranges::all_of(edges, [&](const SurfaceEdge& edge) {
        const auto [from, to] = edge.vertices;
        return edge.triangles.size() != 2 || runsAlong(surface.triangles[edge.triangles[0]], from, to) !=
                                                 runsAlong(surface.triangles[edge.triangles[1]], from, to);
    });
}

/// Returns whether every edge is used equally often in both directions.
bool isClosed(const Surface& surface, const std::vector<SurfaceEdge>& edges) {
    return std::ranges::all_of(edges, [&](const SurfaceEdge& edge) {
        const auto [from, to] = edge.vertices;
        return 2 * std::ranges::count_if(edge.triangles,
                                         [&](int t) { return runsAlong(surface.triangles[t], from, to); }) ==
               std::ssize(edge.triangles);
    });
}

/// Returns whether neighbours can be oriented consistently, which a Möbius band cannot.
bool hasTwoSides(const Surface& surface) {
    RepairReport report;
    const Surface turned = repairSurface(surface, 0, report);
    return isOriented(turned, edgesOf(turned));
}

void measureEdges(const Surface& surface, const std::vector<SurfaceEdge>& edges, SurfaceFacts& facts) {
    facts.edges = static_cast<int>(edges.size());
    if (edges.empty()) return;
    facts.shortestEdge = std::numeric_limits<double>::infinity();
    for (const SurfaceEdge& edge : edges) {
        const double length =
            (surface.points.col(edge.vertices[1]) - surface.points.col(edge.vertices[0])).norm();
        facts.shortestEdge = std::min(facts.shortestEdge, length);
        facts.longestEdge = std::max(facts.longestEdge, length);
        facts.meanEdge += length / static_cast<double>(edges.size());
    }
}

}  // namespace

SurfaceFacts factsOf(const Surface& surface) {
    SurfaceFacts facts;
    const Surface clean = cleaned(surface);
    if (clean.triangles.empty()) return facts;
    Eigen::AlignedBox3d box;
    for (const auto& t : clean.triangles) {
        const Vec3 a = clean.points.col(t[0]), b = clean.points.col(t[1]), c = clean.points.col(t[2]);
        for (const Vec3& p : {a, b, c}) box.extend(p);
        facts.area += (b - a).cross(c - a).norm() / 2;
    }
    facts.low = box.min();
    facts.high = box.max();
    const std::vector<SurfaceEdge> edges = edgesOf(clean);
    measureEdges(clean, edges, facts);
    const std::vector<Part> parts = partsOf(clean, edges);
    facts.parts = static_cast<int>(parts.size());
    Corners corners(clean, edges);
    facts.boundaryLoops = loopsOf(clean, edges, corners);
    if (isClosed(clean, edges)) facts.volume = enclosedVolume(clean, parts, facts.deepest);
    const bool isManifold =
        std::ranges::all_of(edges, [](const SurfaceEdge& edge) { return edge.triangles.size() <= 2; });
    if (!isManifold) return facts;
    facts.sides = hasTwoSides(clean) ? 2 : 1;
    // Euler: V − E + F = 2 parts − 2 genus − loops
    if (facts.sides == 2)
        facts.genus =
            facts.parts - (corners.count() - facts.edges + clean.triangleCount() + facts.boundaryLoops) / 2;
    return facts;
}

}  // namespace wend
