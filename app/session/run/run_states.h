#pragma once

#include "app/document/project_fwd.h"
#include "app/session/shape/shape.h"
#include "core/integration/states_file.h"

namespace wend {

/// What the states of a project's motion up to a time depend on: the mesh and its material as they were made,
/// handles, and settings; not where files are, and nothing that is only seen.
template <int Dim>
StatesHeader statesHeader(const Project& project, const Shape<Dim>& shape, double end);

}  // namespace wend
