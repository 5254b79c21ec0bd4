#include "core/mesh/boundary_loops.h"

#include <map>

namespace wend {

/// Follows the boundary edges from vertex to vertex until each loop is closed.
std::vector<std::vector<Vec2>> boundaryLoops(const SimplicialMesh<2>& mesh) {
    std::multimap<int, int> next;  // along the boundary
    for (const Facet<2>& edge : facetsOf(mesh))
        if (!edge.interior()) next.emplace(edge.vertices[0], edge.vertices[1]);
    std::vector<std::vector<Vec2>> loops;
    while (!next.empty()) {
        std::vector<Vec2>& loop = loops.emplace_back();
        for (auto it = next.begin(); it != next.end();) {
            const int to = it->second;
            loop.push_back(mesh.points.col(it->first));
            next.erase(it);
            it = next.find(to);
        }
    }
    return loops;
}

}  // namespace wend
