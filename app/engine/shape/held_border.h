#pragma once

#include <vector>

#include "app/engine/shape/shape.h"
#include "app/project/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// Returns the handles of a project followed by those that hold the border of its picture (domain.border):
/// the frame's corners stay, its sides stay or slide. Vertices that a handle of the project holds are left to
/// it. In a cage, vertex numbers refer to the surface. Throws InputError for a vertex that the surface does
/// not have.
template <int Dim>
std::vector<Handle<Dim>> heldHandles(const Project& project, const Shape<Dim>& shape);

}  // namespace wend
