#pragma once

#include <QPointF>
#include <QRectF>

#include "app/session/shape_session.h"

namespace wend {

/// The canvas as tools see it: the shape in the plane, and where things are on the screen.
class ToolSurface {
  public:
    virtual ~ToolSurface() = default;
    virtual ShapeSession& session() = 0;
    virtual Vec<2> toShape(const QPointF& widget) const = 0;
    virtual QPointF toWidget(const Vec<2>& shape) const = 0;
    /// A rectangle of selection in widget coordinates; empty to remove it.
    virtual void setMarquee(const QRectF& rectangle) = 0;
    /// The handle under the pointer, or −1.
    virtual void setHovered(int handle) = 0;
    virtual void redraw() = 0;
};

}  // namespace wend
