#pragma once

#include <vector>

#include "app/document/project_fwd.h"
#include "app/session/shape/shape.h"
#include "core/motion/handle.h"

namespace wend {

/// The handles of a project and, last, those that hold the border of its picture (domain.border): the corners
/// of the frame stay where they are, what lies on its sides stays too, or slides along the side. A vertex
/// that a handle of the project holds is left to it. In a cage, vertices by number are those of the surface:
/// the points at their places. Throws InputError for a vertex that the surface does not have.
template <int Dim>
std::vector<Handle<Dim>> heldHandles(const Project& project, const Shape<Dim>& shape);

}  // namespace wend
