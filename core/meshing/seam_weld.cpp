#include "core/meshing/seam_weld.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/surface_edges.h"

namespace wend {
namespace {

constexpr double kOfDiagonal = 1e-3, kOfEdge = 0.1;

/// Returns the surface with one vertex for each place.
Surface joined(const Surface& surface) {
    Surface result = surface;
    const std::vector<int> canonical = canonicalVertices(surface.points);
    for (auto& triangle : result.triangles)
        for (int& v : triangle)
            if (v >= 0 && v < surface.vertexCount()) v = canonical[static_cast<std::size_t>(v)];
    return result;
}

struct OpenEdges {
    std::vector<int> vertices;  // each once, by x
    int open = 0, crowded = 0;
    double shortest = std::numeric_limits<double>::infinity();
};

/// Counts the open edges and those of more than two triangles, and collects the vertices of open ones.
OpenEdges openEdgesOf(const Surface& surface) {
    OpenEdges found;
    std::set<int> vertices;
    for (const SurfaceEdge& edge : edgesOf(surface)) {
        const auto [a, b] = edge.vertices;
        if (edge.triangles.size() > 2) ++found.crowded;
        if (edge.triangles.size() != 1 || a == b) continue;
        ++found.open;
        vertices.insert({a, b});
        found.shortest = std::min(found.shortest, (surface.points.col(a) - surface.points.col(b)).norm());
    }
    found.vertices.assign(vertices.begin(), vertices.end());
    std::ranges::stable_sort(found.vertices, {}, [&](int v) { return surface.points(0, v); });
    return found;
}

/// Returns for each of the vertices the index of the nearest other one within reach, −1 if there is none.
std::vector<int> nearestOf(const std::vector<int>& vertices, const Points3& points, double reach) {
    std::vector<int> nearest(vertices.size(), -1);
    std::vector<double> distance(vertices.size(), reach);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (std::size_t j = i + 1; j < vertices.size(); ++j) {
            const Vec3 way = points.col(vertices[j]) - points.col(vertices[i]);
            if (way.x() > reach) break;
            const double length = way.norm();
            for (const auto& [from, to] : {std::pair{i, j}, {j, i}})
                if (length < distance[from]) {
                    distance[from] = length;
                    nearest[from] = static_cast<int>(to);
                }
        }
    return nearest;
}

}  // namespace

SeamWeld weldSeams(Surface& surface) {
    const Surface before = joined(surface);
    const OpenEdges edges = openEdgesOf(before);
    if (edges.open == 0) return {};
    const double reach =
        std::min(kOfDiagonal * boundingBoxDiagonal<3>(surface.points), kOfEdge * edges.shortest);
    const std::vector<int> nearest = nearestOf(edges.vertices, before.points, reach);
    std::vector<int> target(static_cast<std::size_t>(surface.vertexCount()),
                            -1);  // of the first at each place
    SeamWeld weld;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
        const int j = nearest[i];
        if (j <= static_cast<int>(i) || nearest[static_cast<std::size_t>(j)] != static_cast<int>(i)) continue;
        const auto [kept, moved] =
            std::minmax(edges.vertices[i], edges.vertices[static_cast<std::size_t>(j)]);
        weld.tolerance =
            std::max(weld.tolerance, (before.points.col(kept) - before.points.col(moved)).norm());
        ++weld.vertices;
        target[static_cast<std::size_t>(moved)] = kept;
    }
    if (weld.vertices == 0) return {};
    Surface after = before;
    const std::vector<int> canonical = canonicalVertices(before.points);
    for (std::size_t v = 0; v < canonical.size(); ++v)
        if (const int to = target[static_cast<std::size_t>(canonical[v])]; to >= 0)
            after.points.col(static_cast<Eigen::Index>(v)) = before.points.col(to);
    const OpenEdges left = openEdgesOf(joined(after));
    if (left.open >= edges.open || left.crowded > edges.crowded) return {};
    surface.points = after.points;
    return weld;
}

}  // namespace wend
