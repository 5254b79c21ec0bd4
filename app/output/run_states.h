#pragma once

#include "app/engine/shape/shape.h"
#include "app/project/project_fwd.h"
#include "core/integration/states_file.h"

namespace wend {

/// Returns the header of the states of a project's motion up to a time, with everything that they depend on:
/// the mesh and its material as they were made, handles, and settings, but neither the locations of files nor
/// what only affects the display.
template <int Dim>
StatesHeader statesHeader(const Project& project, const Shape<Dim>& shape, double end);

}  // namespace wend
