#pragma once

#include <optional>
#include <string>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns a place for a joint of two parts: the middle of the vertices of one that are in the other at rest,
/// or the nearest of them to it that is in both; nothing if the parts do not overlap.
std::optional<Vec<2>> jointPlace(const SimplicialMesh<2>& rest, const std::string& part,
                                 const std::string& other);

}  // namespace wend
