#pragma once

#include <type_traits>

#include "app/tools/solid_surface.h"
#include "app/tools/tool.h"
#include "app/tools/tool_surface.h"

namespace wend {

template <int Dim>
using SurfaceOf = std::conditional_t<Dim == 2, ToolSurface, SolidSurface>;

/// A tool with the view of pictures, or of solids, that it works on.
template <int Dim>
class ShapeTool : public Tool {
  public:
    explicit ShapeTool(SurfaceOf<Dim>& surface) : m_surface(surface) {}

  protected:
    SurfaceOf<Dim>& surface() const { return m_surface; }
    ShapeSession& session() const { return m_surface.session(); }

  private:
    SurfaceOf<Dim>& m_surface;
};

}  // namespace wend
