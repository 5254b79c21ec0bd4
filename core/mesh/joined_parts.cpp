#include "core/mesh/joined_parts.h"

#include <algorithm>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/mesh/used_vertices.h"

namespace wend {
namespace {

template <int Dim>
DisjointSets connectedParts(const SimplicialMesh<Dim>& mesh) {
    DisjointSets parts(mesh.vertexCount());
    for (const auto& cell : mesh.cells)
        for (int v : cell) parts.join(v, cell[0]);
    return parts;
}

/// Sorts, and returns whether the permutation was odd. Two facets at one place face each other if one
/// permutation is odd and the other even.
template <std::size_t N>
bool sortedOddly(std::array<int, N>& ids) {
    bool odd = false;
    for (std::size_t i = 1; i < N; ++i)
        for (std::size_t k = i; k > 0 && ids[k] < ids[k - 1]; --k, odd = !odd) std::swap(ids[k], ids[k - 1]);
    return odd;
}

/// The boundary facets at one place, with their orientation.
template <int Dim>
struct Place {
    std::vector<Facet<Dim>> facets;
    std::vector<bool> odd;
};

/// Sorts the boundary facets by their place, that is, by the first vertices at their corners.
template <int Dim>
auto placesOf(const SimplicialMesh<Dim>& mesh, const std::vector<int>& first) {
    std::map<std::array<int, Dim>, Place<Dim>> places;
    for (const auto& facet : facetsOf<Dim>(mesh)) {
        if (facet.interior()) continue;
        std::array<int, Dim> key;
        std::ranges::transform(facet.vertices, key.begin(), [&](int v) { return first[v]; });
        const bool odd = sortedOddly(key);
        Place<Dim>& place = places[key];
        place.facets.push_back(facet);
        place.odd.push_back(odd);
    }
    return places;
}

}  // namespace

/// Unites vertices at one place where boundary facets of different parts coincide, if the joined mesh is
/// valid.
template <int Dim>
JoinedParts<Dim> joinedParts(const SimplicialMesh<Dim>& mesh) {
    JoinedParts<Dim> result{mesh, 0};
    const std::vector<int> first = firstAtPlace<Dim>(mesh.points);
    const auto isFirst = [&, v = 0](int id) mutable { return id == v++; };
    if (std::ranges::all_of(first, isFirst)) return result;
    DisjointSets parts = connectedParts<Dim>(mesh), joined(mesh.vertexCount());
    for (const auto& [key, place] : placesOf<Dim>(mesh, first)) {
        if (place.facets.size() != 2 || place.odd[0] == place.odd[1]) continue;
        const auto &a = place.facets[0].vertices, &b = place.facets[1].vertices;
        if (parts.root(a[0]) == parts.root(b[0])) continue;
        for (int v : a)
            for (int w : b)
                if (first[v] == first[w]) joined.join(v, w);
    }
    for (auto& cell : result.mesh.cells)
        for (int& v : cell) v = joined.root(v);
    for (int v = 0; v < mesh.vertexCount(); ++v) result.vertices += joined.root(v) != v;
    try {
        requireValid<Dim>(result.mesh);
    } catch (const InputError&) {
        return {mesh, 0};
    }
    return result;
}

template JoinedParts<2> joinedParts<2>(const SimplicialMesh<2>&);
template JoinedParts<3> joinedParts<3>(const SimplicialMesh<3>&);

}  // namespace wend
