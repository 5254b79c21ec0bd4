#pragma once

#include <vector>

#include "app/document/project.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The handles of a project and, last, those that hold the border of its picture (domain.border): the corners
/// of the frame stay where they are, what lies on its sides stays too, or slides along the side. A vertex
/// that a handle of the project holds is left to it. `frame`: the picture's size; zero for what is no
/// picture.
template <int Dim>
std::vector<Handle<Dim>> heldHandles(const Project& project, const SimplicialMesh<Dim>& rest,
                                     const Vec<2>& frame);

}  // namespace wend
