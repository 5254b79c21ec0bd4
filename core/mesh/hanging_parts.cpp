#include "core/mesh/hanging_parts.h"

#include <Eigen/Geometry>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/mesh/used_vertices.h"

namespace wend {
namespace {

constexpr double kOnLine = 1e-9;  // of the line's length

/// Returns whether a part turns freely at a joint: a vertex, or in space vertices on a line.
template <int Dim>
bool turnsFreely(const Points<Dim>& points, const std::vector<int>& joint) {
    if (joint.size() == 1) return true;
    if (Dim == 2) return false;
    const Vec<Dim> first = points.col(joint[0]);
    Vec<Dim> line = Vec<Dim>::Zero();
    for (const int v : joint)
        if ((points.col(v) - first).norm() > line.norm()) line = points.col(v) - first;
    return std::ranges::all_of(joint, [&](int v) {
        const Vec<Dim> offset = points.col(v) - first;
        return (offset - offset.dot(line) / line.squaredNorm() * line).norm() <= kOnLine * line.norm();
    });
}

/// Connected components, and the vertices that connect them.
template <int Dim, std::size_t N>
class Parts {
  public:
    /// `sets` are those of the cells.
    Parts(const Points<Dim>& points, const std::vector<std::array<int, N>>& cells, DisjointSets& sets)
        : m_points(points), m_groups(static_cast<int>(cells.size())) {
        std::map<int, std::vector<int>> partsAt;  // vertices
        for (int c = 0; c < static_cast<int>(cells.size()); ++c) {
            const int part = sets.root(c);
            ++m_sizes[part];
            for (const int v : cells[c]) partsAt[v].push_back(part);
        }
        for (auto& [vertex, parts] : partsAt) {
            std::ranges::sort(parts);
            parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
            for (const int part : parts) m_groups.join(part, parts.front());
            if (parts.size() > 1)
                for (const int part : parts) m_joints[part].push_back(vertex);
        }
    }
    /// Returns the parts that turn freely at their joint, except the largest of each group of touching parts.
    std::vector<HangingPart> hanging() {
        std::map<int, int> largest;  // part of each group
        for (const auto& [part, size] : m_sizes) {
            const auto known = largest.try_emplace(m_groups.root(part), part).first;
            if (size > m_sizes[known->second]) known->second = part;
        }
        std::vector<HangingPart> found;
        for (const auto& [part, joint] : m_joints)
            if (largest[m_groups.root(part)] != part && turnsFreely<Dim>(m_points, joint))
                found.push_back({joint, m_sizes[part], part});
        return found;
    }

  private:
    const Points<Dim>& m_points;
    DisjointSets m_groups;
    std::map<int, int> m_sizes;                // by part, which is called by its first cell
    std::map<int, std::vector<int>> m_joints;  // the same
};

}  // namespace

template <int Dim>
std::vector<HangingPart> hangingParts(const SimplicialMesh<Dim>& mesh) {
    DisjointSets sets(mesh.cellCount());
    for (const auto& facet : facetsOf<Dim>(mesh))
        if (facet.interior()) sets.join(facet.cells[0], facet.cells[1]);
    return Parts<Dim, Dim + 1>(mesh.points, mesh.cells, sets).hanging();
}

/// Treats the triangles as cells that are connected by edges of exactly two.
std::vector<HangingPart> hangingParts(const Points3& points,
                                      const std::vector<std::array<int, 3>>& triangles) {
    const std::vector<int> first = firstAtPlace<3>(points);
    std::vector<std::array<int, 3>> cells = triangles;
    std::map<std::array<int, 2>, std::vector<int>> edges;
    for (std::size_t t = 0; t < cells.size(); ++t) {
        for (int& v : cells[t]) v = first[v];
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(cells[t][k], cells[t][(k + 1) % 3]);
            edges[{low, high}].push_back(static_cast<int>(t));
        }
    }
    DisjointSets sets(static_cast<int>(cells.size()));
    for (const auto& [edge, around] : edges)
        if (around.size() == 2) sets.join(around[0], around[1]);
    return Parts<3, 3>(points, cells, sets).hanging();
}

template std::vector<HangingPart> hangingParts<2>(const SimplicialMesh<2>&);
template std::vector<HangingPart> hangingParts<3>(const SimplicialMesh<3>&);

}  // namespace wend
