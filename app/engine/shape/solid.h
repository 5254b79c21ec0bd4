#pragma once

#include <stop_token>
#include <string>

#include "app/engine/shape/shape.h"
#include "app/project/project_fwd.h"
#include "core/meshing/surface.h"

namespace wend {

/// Selects whether messages name project keys and commands. The window uses its own words.
enum class Advice { Keys, None };

/// Returns the shape of a project in space, without material (paths relative to `folder`). A surface that
/// bounds no volume throws SurfaceError (also if the repairs did not help), everything else InputError, with
/// the file's name; Cancelled when stopped.
Shape<3> loadSolid(const Domain& domain, const Design& design, const std::string& folder,
                   std::stop_token stop = {}, Advice advice = Advice::Keys);

/// Returns the surface of a skin, with its labels.
Surface surfaceOf(const Skin& skin);

}  // namespace wend
