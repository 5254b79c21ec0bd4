#pragma once

#include "app/tools/gizmo.h"

namespace wend {

/// The ring around the selection in a picture: its dot rotates, its square scales. It is dotted around a
/// single point, which becomes a small disc when its ring is dragged.
class PinRing : public Gizmo {
  public:
    void setGrip(Grip::Kind kind) override { m_kind = kind; }
    bool comesFirst() const override { return false; }
    std::optional<Part> anywhere() const override;
    std::optional<Part> partAt(const ShapeView& view, const QPointF& widget) const override;
    bool turnsPointAt(const ShapeView& view, const QPointF& widget) const override;
    QString hint() const override;

    void begin(const Part& part, const ShapeView& view, const QPointF& widget) override;
    Grip grip(const ShapeView& view) const override;
    Amount drag(const ShapeView& view, const QPointF& widget, bool snaps = false) override;
    /// A typed length is along the axis, or where the drag went last.
    Amount typed(double number, const ShapeView& view) const override;

    void paint(QPainter& painter, const ShapeView& view, const std::optional<Part>& lit) const override;
    /// Moving pins have no ring.
    void paintDragged(QPainter& painter, const ShapeView& view, const Amount& amount) const override;

  private:
    void takePlace() override { m_turned = 0; }
    QPointF spot(Grip::Kind kind, const QPointF& centre) const;
    std::optional<double> angleAt(const ShapeView& view, const QPointF& widget) const;

    Grip::Kind m_kind = Grip::Kind::Move;
    Vec3 m_startPoint = Vec3::Zero(), m_way = Vec3::Zero();
    std::optional<double> m_lastAngle;  // none while the pointer has not left the middle
    double m_angle = 0, m_lead = 0, m_startDistance = 1, m_turned = 0;
};

}  // namespace wend
