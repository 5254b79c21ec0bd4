#pragma once

#include <QPainter>
#include <optional>

#include "app/tools/gizmo_base.h"
#include "app/tools/tool_surface.h"

namespace wend {

/// The ring around the selection in a picture, of constant size on the screen: its dot rotates, its square
/// scales. It is dotted around a single point, which becomes a small disc when its ring is dragged.
class PinRing : public GizmoBase<2> {
  public:
    /// Pins take precedence over parts above them.
    static constexpr bool kComesFirst = false;

    void place(const Vec<2>& centre, bool canTurn) {
        GizmoBase::place(centre, canTurn);
        m_turned = 0;
    }
    void setGrip(Grip::Kind kind) { m_kind = kind; }
    /// Returns the part that a drag from anywhere uses; none if pins are moved directly.
    std::optional<Part> anywhere() const;
    std::optional<Part> partAt(const ToolSurface& surface, const QPointF& widget) const;
    /// Returns true if a drag from here rotates a single point.
    bool turnsPointAt(const ToolSurface& surface, const QPointF& widget) const;
    /// Returns the hint over a part.
    static QString hint();

    void begin(const Part& part, const ToolSurface& surface, const QPointF& widget);
    Grip grip(const ToolSurface& surface) const;
    /// Returns the amount of the drag; `snaps`: to 15°.
    Amount drag(const ToolSurface& surface, const QPointF& widget, bool snaps = false);
    /// Degrees, a factor, or a length along the axis or where it went last.
    Amount typed(double number, const ToolSurface& surface) const;

    void paint(QPainter& painter, const ToolSurface& surface, const std::optional<Part>& lit) const;
    /// Draws the ring during a drag; moving pins have none.
    void paintDragged(QPainter& painter, const ToolSurface& surface, const Amount& amount) const;

  private:
    QPointF spot(Grip::Kind kind, const QPointF& centre) const;
    std::optional<double> angleAt(const ToolSurface& surface, const QPointF& widget) const;

    Grip::Kind m_kind = Grip::Kind::Move;
    Vec<2> m_startPoint = Vec<2>::Zero(), m_way = Vec<2>::Zero();
    std::optional<double> m_lastAngle;  // none while the pointer has not left the middle
    double m_angle = 0, m_lead = 0, m_startDistance = 1, m_turned = 0;
};

}  // namespace wend
