#pragma once

#include "core/mesh/formats/mesh_format.h"

namespace wend::formats {

/// Returns a bag with only those kinds of cell that the format holds: cells lose the nodes between their
/// corners, or are split into triangles, tetrahedra or lines, or are left out.
MeshFile asHeld(const MeshFormat& format, MeshFile bag);

/// Describes in one line what a file of this format does not hold of a mesh: "2 lines and the names of 3
/// groups are not in an STL file". Returns an empty string if nothing is lost.
std::string lostParts(const MeshFormat& format, const MeshFile& bag);

}  // namespace wend::formats
