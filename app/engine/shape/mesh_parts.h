#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/mesh/region.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns the cells that are connected with one through facets, in increasing order.
template <int Dim>
std::vector<int> partOf(const SimplicialMesh<Dim>& mesh, int cell);

/// Returns the name of the part of a picture that a cell belongs to; empty if there are no parts.
std::string partNameOf(const std::vector<MeshPart>& parts, int cell);

/// Returns a region around the points at rest: in the plane their outer outline, in space a box.
template <int Dim>
Region<Dim> regionAround(const SimplicialMesh<Dim>& mesh, const std::vector<int>& cells);

/// Returns a region that holds the whole shape.
template <int Dim>
Region<Dim> regionOfAll(const SimplicialMesh<Dim>& mesh);

/// Returns a place for a joint of two parts: the middle of the vertices of one that are in the other at rest,
/// or the nearest of them to it that is in both; nothing if the parts do not overlap.
std::optional<Vec2> jointPlace(const SimplicialMesh<2>& rest, const std::string& part,
                               const std::string& other);

}  // namespace wend
