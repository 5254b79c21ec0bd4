#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QRectF>
#include <QString>

#include "app/session/shape_session.h"

namespace wend {

/// The canvas as tools see it: the shape, and where things are on the screen.
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
};

/// One way to work on the shape with pointer and keys. The canvas passes on what it does not need for
/// navigation.
class Tool {
  public:
    explicit Tool(ToolSurface& surface) : m_surface(surface) {}
    virtual ~Tool() = default;

    /// One line for the status bar: what the pointer does now.
    virtual QString hint() const = 0;
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
    virtual void press(const QMouseEvent& event) = 0;
    virtual void move(const QMouseEvent& event) = 0;
    virtual void release(const QMouseEvent& event) = 0;
    /// True if the key was used.
    virtual bool key(const QKeyEvent& event) = 0;
    /// Gives up the gesture, as if it had not begun.
    virtual void cancel() = 0;

  protected:
    ToolSurface& surface() const { return m_surface; }
    ShapeSession& session() const { return m_surface.session(); }

  private:
    ToolSurface& m_surface;
};

}  // namespace wend
