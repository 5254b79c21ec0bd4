#pragma once

#include "app/tools/gizmo.h"

namespace wend {

/// A manipulator around a point of a solid: arrows, squares, rings and a disc.
class Manipulator : public Gizmo {
  public:
    /// Tilt: an arrow along the third axis and rings around the first two, for a plane.
    enum class Mode { Move, Turn, Grow, Tilt };
    void setMode(Mode mode) { m_mode = mode; }
    void setGrip(Grip::Kind kind) override;
    bool comesFirst() const override { return true; }
    using Gizmo::place;
    /// The axes are the columns.
    void place(const Vec3& centre, const Mat<3>& axes);
    Vec3 axis(int k) const { return m_axes.col(k); }
    QString hint() const override;

    std::optional<Part> partAt(const ShapeView& view, const QPointF& widget) const override;
    void begin(const Part& part, const ShapeView& view, const QPointF& widget) override;
    Grip grip(const ShapeView& view) const override;
    Amount drag(const ShapeView& view, const QPointF& widget, bool snaps = false) override;
    Amount typed(double number, const ShapeView& view) const override;

    void paint(QPainter& painter, const ShapeView& view, const std::optional<Part>& lit) const override;
    /// Draws the manipulator at the dragged place.
    void paintDragged(QPainter& painter, const ShapeView& view, const Amount& amount) const override;

  private:
    std::vector<Part> parts() const;
    std::vector<Vec3> outline(const Part& part, const ShapeView& view) const;
    Vec3 normalOf(const Part& part, const ShapeView& view) const;
    double length(const ShapeView& view) const;
    Vec3 alongOneAxis(const Vec3& way) const;
    Vec3 pointAt(const ShapeView& view, const QPointF& widget) const;
    double angleAt(const ShapeView& view, const QPointF& widget) const;
    double distanceAt(const ShapeView& view, const QPointF& widget) const;

    Mode m_mode = Mode::Move;
    Mat<3> m_axes = Mat<3>::Identity();
    Vec3 m_startPoint = Vec3::Zero();
    double m_lastAngle = 0, m_angle = 0, m_startDistance = 1;
};

}  // namespace wend
