#include "core/motion/rest_guide.h"

#include <algorithm>

namespace wend {

template <int Dim>
GuideMesh<Dim> restGuide(const SimplicialMesh<Dim>& rest, const std::vector<int>& vertices) {
    std::vector<bool> isHeld(static_cast<std::size_t>(rest.vertexCount()), false);
    for (const int v : vertices) isHeld[v] = true;
    GuideMesh<Dim> guide;
    guide.points = rest.points;
    std::vector<std::array<int, 2>> edges;
    for (const Facet<Dim>& facet : facetsOf(rest)) {
        if (facet.interior()) continue;
        for (int k = 0; k < Dim; ++k) {
            const std::array<int, 2> edge{facet.vertices[k], facet.vertices[(k + 1) % Dim]};
            if (isHeld[edge[0]] && isHeld[edge[1]] && (Dim == 3 || k == 0)) edges.push_back(edge);
        }
        if constexpr (Dim == 3)
            if (std::ranges::all_of(facet.vertices, [&](int v) { return isHeld[v]; }))
                guide.triangles.push_back(facet.vertices);
    }
    if (!guide.triangles.empty()) return guide;
    for (auto& edge : edges) std::ranges::sort(edge);
    std::ranges::sort(edges);
    edges.erase(std::ranges::unique(edges).begin(), edges.end());
    guide.segments = std::move(edges);
    return guide;
}

template GuideMesh<2> restGuide(const SimplicialMesh<2>&, const std::vector<int>&);
template GuideMesh<3> restGuide(const SimplicialMesh<3>&, const std::vector<int>&);

}  // namespace wend
