#include "core/meshing/surface_faults.h"

#include <algorithm>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/meshing/surface_edges.h"

namespace wend {
namespace {

using Edge = std::array<int, 2>;

/// The triangles at edges, which problems name by the first vertices at their places.
class EdgeTriangles {
  public:
    explicit EdgeTriangles(const Surface& surface) {
        const std::vector<int> first = canonicalVertices(surface.points);
        Surface joined{surface.points, surface.triangles, {}};
        for (auto& triangle : joined.triangles)
            for (int& v : triangle)
                if (v >= 0 && v < surface.vertexCount()) v = first[v];
        m_edges = edgesOf(joined);
    }
    std::vector<int> at(const Edge& edge) const {
        const auto found = std::ranges::lower_bound(m_edges, edge, {}, &SurfaceEdge::vertices);
        return found != m_edges.end() && found->vertices == edge ? found->triangles : std::vector<int>{};
    }

  private:
    std::vector<SurfaceEdge> m_edges;
};

std::vector<std::vector<int>> atEdges(const EdgeTriangles& triangles, const std::vector<Edge>& edges) {
    std::vector<std::vector<int>> cases;
    for (const Edge& edge : edges) cases.push_back(triangles.at(edge));
    return cases;
}

/// Returns the triangles around every hole, which is a set of connected open edges.
std::vector<std::vector<int>> holes(const Surface& surface, const EdgeTriangles& triangles,
                                    const std::vector<Edge>& openEdges) {
    DisjointSets sets(surface.vertexCount());
    for (const Edge& edge : openEdges) sets.join(edge[0], edge[1]);
    std::map<int, std::vector<int>> byRoot;
    for (const Edge& edge : openEdges) {
        auto& hole = byRoot[sets.root(edge[0])];
        const std::vector<int> there = triangles.at(edge);
        hole.insert(hole.end(), there.begin(), there.end());
    }
    std::vector<std::vector<int>> cases;
    for (const auto& [root, hole] : byRoot) cases.push_back(hole);
    return cases;
}

std::vector<std::vector<int>> alone(const std::vector<int>& triangles) {
    std::vector<std::vector<int>> cases;
    for (const int t : triangles) cases.push_back({t});
    return cases;
}

}  // namespace

std::vector<FaultKind> faultsOf(const Surface& surface, const SurfaceProblems& problems) {
    const EdgeTriangles triangles(surface);
    std::vector<std::vector<int>> crossings;
    for (const auto& pair : problems.intersecting) crossings.push_back({pair[0], pair[1]});
    std::vector<FaultKind> kinds{{"missing_vertex", alone(problems.badIndex)},
                                 {"crossing", std::move(crossings)},
                                 {"hole", holes(surface, triangles, problems.openEdges)},
                                 {"crowded_edge", atEdges(triangles, problems.nonManifoldEdges)},
                                 {"flat", alone(problems.degenerate)},
                                 {"duplicate", alone(problems.duplicate)},
                                 {"turned_edge", atEdges(triangles, problems.misoriented)}};
    std::erase_if(kinds, [](const FaultKind& kind) { return kind.cases.empty(); });
    return kinds;
}

std::vector<int> SurfaceProblems::triangles(const Surface& surface) const {
    std::vector<int> list;
    for (const FaultKind& kind : faultsOf(surface, *this))
        for (const auto& one : kind.cases) list.insert(list.end(), one.begin(), one.end());
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

}  // namespace wend
