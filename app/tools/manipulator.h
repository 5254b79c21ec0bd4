#pragma once

#include <optional>

#include "app/tools/gizmo_base.h"
#include "app/tools/solid_surface.h"

namespace wend {

/// A manipulator around a point: arrows, squares, rings and a disc that are dragged to move, rotate or scale.
/// Constant size on the screen.
class Manipulator : public GizmoBase<3> {
  public:
    /// Tilt: an arrow along the third axis and rings around the first two, for a plane.
    enum class Mode { Move, Turn, Grow, Tilt };
    /// Parts take precedence over pins below them.
    static constexpr bool kComesFirst = true;

    void setMode(Mode mode) { m_mode = mode; }
    void setGrip(Grip::Kind kind);
    using GizmoBase::place;
    /// The axes are the columns.
    void place(const Vec<3>& centre, const Mat<3>& axes);
    Vec<3> axis(int k) const { return m_axes.col(k); }
    /// A drag outside all parts does not use the manipulator.
    static std::optional<Part> anywhere() { return {}; }
    static bool turnsPointAt(const SolidSurface&, const QPointF&) { return false; }
    /// Returns the hint over a part.
    static QString hint();

    /// Returns the part under the pointer.
    std::optional<Part> partAt(const SolidSurface& surface, const QPointF& widget) const;
    /// Starts a drag, which drag() measures from here; the centre stays until the end.
    void begin(const Part& part, const SolidSurface& surface, const QPointF& widget);
    /// `snaps`: angles to 15°, displacements in a plane to one of its axes.
    Amount drag(const SolidSurface& surface, const QPointF& widget, bool snaps = false);
    Grip grip(const SolidSurface& surface) const;
    /// The amount that a typed number means: a length along the axis, degrees, or a factor.
    Amount typed(double number, const SolidSurface& surface) const;

    void paint(QPainter& painter, const SolidSurface& surface, const std::optional<Part>& lit) const;
    /// Draws the manipulator at the dragged place.
    void paintDragged(QPainter& painter, const SolidSurface& surface, const Amount& amount) const;

  private:
    std::vector<Part> parts() const;
    std::vector<Vec<3>> outline(const Part& part, const SolidSurface& surface) const;
    Vec<3> normalOf(const Part& part, const SolidSurface& surface) const;
    double length(const SolidSurface& surface) const;
    Vec<3> alongOneAxis(const Vec<3>& way) const;
    Vec<3> pointAt(const SolidSurface& surface, const QPointF& widget) const;
    double angleAt(const SolidSurface& surface, const QPointF& widget) const;
    double distanceAt(const SolidSurface& surface, const QPointF& widget) const;

    Mode m_mode = Mode::Move;
    Mat<3> m_axes = Mat<3>::Identity();
    Vec<3> m_startPoint = Vec<3>::Zero();
    double m_lastAngle = 0, m_angle = 0, m_startDistance = 1;
};

}  // namespace wend
