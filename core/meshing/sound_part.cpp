#include "core/meshing/sound_part.h"

#include <algorithm>

#include "core/meshing/surface_edges.h"

namespace wend {

SoundPart::SoundPart(const Surface& whole) : surface{whole.points, {}, {}} {
    const SurfaceProblems problems = checkSurface(whole, 0);
    std::vector<bool> left(whole.triangles.size(), false);
    for (const auto* list : {&problems.badIndex, &problems.degenerate, &problems.duplicate})
        for (const int t : *list) left[t] = true;
    const std::vector<int> first = canonicalVertices(whole.points);
    for (int t = 0; t < whole.triangleCount(); ++t) {
        if (left[t]) continue;
        auto ids = whole.triangles[t];
        for (int& id : ids) id = first[id];
        surface.triangles.push_back(ids);
        triangles.push_back(t);
    }
}

/// Floods from the triangle over edges of exactly two triangles that run in opposite directions.
std::vector<int> SoundPart::patchOf(int triangle) const {
    const auto at = std::ranges::lower_bound(triangles, triangle);
    if (at == triangles.end() || *at != triangle) return {};
    std::vector<std::vector<int>> beside(triangles.size());
    for (const SurfaceEdge& edge : edgesOf(surface)) {
        if (edge.triangles.size() != 2) continue;
        const int a = edge.triangles[0], b = edge.triangles[1];
        const auto [from, to] = edge.vertices;
        if (runsAlong(surface.triangles[a], from, to) == runsAlong(surface.triangles[b], from, to)) continue;
        beside[a].push_back(b);
        beside[b].push_back(a);
    }
    std::vector<bool> seen(triangles.size(), false);
    std::vector<int> patch{static_cast<int>(at - triangles.begin())};
    seen[patch[0]] = true;
    for (std::size_t i = 0; i < patch.size(); ++i)
        for (const int next : beside[patch[i]])
            if (!seen[next]) {
                seen[next] = true;
                patch.push_back(next);
            }
    for (int& t : patch) t = triangles[t];
    return patch;
}

}  // namespace wend
