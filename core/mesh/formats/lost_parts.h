#pragma once

#include "core/mesh/formats/mesh_format.h"

namespace wend::formats {

/// A bag with nothing but kinds of cell that the format holds: cells with nodes between their corners lose
/// those, or cells are split into triangles, tetrahedra or lines, or left out.
MeshFile asHeld(const MeshFormat& format, MeshFile bag);

/// What a file of this format does not hold of a mesh, in one line: "2 lines and the names of 3 groups are
/// not in an STL file". Empty if nothing is lost.
std::string lostParts(const MeshFormat& format, const MeshFile& bag);

}  // namespace wend::formats
