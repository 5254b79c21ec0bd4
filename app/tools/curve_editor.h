#pragma once

#include "app/document/curve_edits.h"
#include "app/tools/solid_surface.h"

namespace wend {

/// The Bézier points of the curve that the one selected handle follows last: shown, and dragged along the
/// screen. One undo step per drag.
class CurveEditor {
  public:
    explicit CurveEditor(SolidSurface& surface) : m_surface(surface) {}

    /// The point within reach, or −1. The first one is where the handle is when the motion begins: fixed.
    int pointAt(const QPointF& widget) const;
    bool isDragging() const { return m_dragged >= 0; }
    void begin(int point, const QPointF& widget);
    void drag(const QPointF& widget);
    /// Puts the points into the document.
    void finish();
    void cancel() { m_dragged = -1; }
    void paint(QPainter& painter, const QPointF& pointer) const;

  private:
    int handle() const;
    /// In space, as they are drawn; empty without a curve.
    std::vector<Vec<3>> points() const;
    Vec<3> shift() const;

    SolidSurface& m_surface;
    int m_dragged = -1;
    QPointF m_from;
    Vec<3> m_by = Vec<3>::Zero();
};

}  // namespace wend
