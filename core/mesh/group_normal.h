#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/types.h"

namespace wend {

struct MeshFile;

/// The facets of a group: its triangles, in the plane its lines (in the coordinates of the file's plane), or
/// for a list of vertices those of the boundary between them.
template <int Dim>
struct GroupFacets {
    Points<Dim> points;  // all of the file
    std::vector<std::array<int, Dim>> facets;
};
/// Returns these facets. Throws InputError if the group has none.
template <int Dim>
GroupFacets<Dim> groupFacets(const MeshFile& file, const std::string& name);

/// Returns the mean unit normal of a group: Σ A_f n_f, normalized, over its facets f of measure A_f and
/// normal n_f. The facets are the group's triangles (in the plane its lines), or for a list of vertices those
/// of the boundary between them. Normals point out of the mesh where it is on one side of the facet only, and
/// otherwise as the file orders the vertices; those of a closed surface always point out of it. Throws
/// InputError if the group has no facet, or if its normals cancel out.
template <int Dim>
Vec<Dim> groupNormal(const MeshFile& file, const std::string& name);

}  // namespace wend
