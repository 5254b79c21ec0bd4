#pragma once

#include <QPainter>
#include <functional>

#include "app/panels/marks.h"
#include "app/panels/pin_animation.h"
#include "app/panels/theme.h"
#include "app/session/pose_faults.h"
#include "app/session/shape_session.h"
#include "app/view/view_transform.h"

namespace wend {

/// Draws what lies over the shape, crisp at any zoom: pins, their paths, the worst place.
class OverlayPainter {
  public:
    OverlayPainter(QPainter& painter, const ViewTransform& view, const Theme& theme)
        : m_painter(painter), m_marks(painter), m_view(view), m_theme(theme) {}

    void paths(ShapeSession& session, int hovered);
    /// Also, faintly, the handles that do not hold at the time that is shown. `isCovered`: something of the
    /// shape is seen in front.
    void pins(ShapeSession& session, const PinAnimation& animation, int hovered,
              const std::function<bool(const PinView<2>&)>& isCovered);
    void worst(const PosedFrame<2>& frame, int cell);
    /// The edges that cross, and the triangles that have blown up.
    void faults(const PosedFrame<2>& frame, const PoseFaults<2>& faults);

  private:
    QPolygonF toWidget(const std::vector<Vec<2>>& points) const;
    void frames(const Handle<2>& handle, const Vec<2>& start);
    void spots(const PinView<2>& view, const QColor& colour);
    void region(const Handle<2>& handle, const PinView<2>& view, const PosedFrame<2>& frame, bool selected,
                bool hovered);

    QPainter& m_painter;
    Marks m_marks;
    const ViewTransform& m_view;
    const Theme& m_theme;
};

}  // namespace wend
