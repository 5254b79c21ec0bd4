#pragma once

#include <QPointF>

#include "app/tools/shape_surface.h"

namespace wend {

/// The canvas as tools see it: the shape in the plane, and where things are on the screen.
class ToolSurface : public ShapeSurface<2> {
  public:
    virtual Vec<2> toShape(const QPointF& widget) const = 0;
};

/// Returns the point under the pointer.
inline Vec<2> acrossTheScreen(const ToolSurface& surface, const Vec<2>&, const QPointF& widget) {
    return surface.toShape(widget);
}
inline Vec3 acrossTheScreen(const ToolSurface& surface, const Vec3&, const QPointF& widget) {
    return inSpace(surface.toShape(widget));
}

}  // namespace wend
