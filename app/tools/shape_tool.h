#pragma once

#include <type_traits>

#include "app/tools/solid_surface.h"
#include "app/tools/tool_surface.h"

namespace wend {

template <int Dim>
using SurfaceOf = std::conditional_t<Dim == 2, ToolSurface, SolidSurface>;

/// A tool that works on pictures as on solids.
template <int Dim>
using ShapeTool = std::conditional_t<Dim == 2, PictureTool, SolidTool>;

}  // namespace wend
