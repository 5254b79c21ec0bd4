#pragma once

#include <QPainter>

#include "app/panels/marks.h"
#include "app/panels/pin_animation.h"
#include "app/panels/theme.h"
#include "app/tools/solid_surface.h"

namespace wend {

/// The pins and their paths, as they are drawn.
std::vector<Vec<3>> pathPoints(ShapeSession& session);

/// Draws what lies over a solid: pins, their paths, the worst place, the axes of the world.
class SolidPainter {
  public:
    SolidPainter(QPainter& painter, SolidSurface& surface, const Theme& theme)
        : m_painter(painter), m_marks(painter), m_surface(surface), m_theme(theme) {}

    void paths();
    void pins(const PinAnimation& animation, int hovered);
    /// The cross where the worst cell is seen, or a faint ring over where it is hidden.
    void worst(const PosedFrame<3>& frame, int cell);
    /// A small cross of axes in the corner.
    void compass(const QPointF& at, const Mat<3>& worldToScreen);

  private:
    QPolygonF toWidget(const std::vector<Vec<3>>& points) const;
    void frames(const Handle<3>& handle, const Vec<3>& start);
    void region(const PinView<3>& view);
    void spots(const PinView<3>& view, const QColor& colour);

    QPainter& m_painter;
    Marks m_marks;
    SolidSurface& m_surface;
    const Theme& m_theme;
};

}  // namespace wend
