#pragma once

#include <QPointF>
#include <QRectF>

#include "app/tools/shape_surface.h"
#include "app/tools/tool.h"

namespace wend {

/// The canvas as tools see it: the shape in the plane, and where things are on the screen.
class ToolSurface : public ShapeSurface<2> {
  public:
    virtual Vec<2> toShape(const QPointF& widget) const = 0;
    /// A rectangle of selection in widget coordinates; empty to remove it.
    virtual void setMarquee(const QRectF& rectangle) = 0;
    /// The handle under the pointer, or −1.
    virtual void setHovered(int handle) = 0;
};

/// A tool in the plane.
class PictureTool : public Tool {
  public:
    explicit PictureTool(ToolSurface& surface) : m_surface(surface) {}

  protected:
    ToolSurface& surface() const { return m_surface; }
    ShapeSession& session() const { return m_surface.session(); }

  private:
    ToolSurface& m_surface;
};

}  // namespace wend
