#pragma once

#include <optional>

#include "app/document/grip.h"
#include "app/tools/solid_surface.h"

namespace wend {

/// Arrows, squares, rings and a disc around a point, that are dragged to move, turn or scale. Of constant
/// size on the screen.
class Manipulator {
  public:
    /// Tilt: an arrow along the third axis and rings around the first two, for a plane.
    enum class Mode { Move, Turn, Grow, Tilt };
    struct Part {
        Grip::Kind kind = Grip::Kind::Move;
        int axis = -1;       // −1: none, along the screen
        bool plane = false;  // moves in the plane across the axis
        bool operator==(const Part&) const = default;
    };

    void setMode(Mode mode) { m_mode = mode; }
    Mode mode() const { return m_mode; }
    /// The axes are the columns.
    void place(const Vec<3>& centre, const Mat<3>& axes = Mat<3>::Identity());
    const Vec<3>& centre() const { return m_centre; }
    Vec<3> axis(int k) const { return m_axes.col(k); }

    /// The part under the pointer.
    std::optional<Part> partAt(const SolidSurface& surface, const QPointF& widget) const;
    /// From now on `drag` measures from here; the centre stays where it is until the end.
    void begin(const Part& part, const SolidSurface& surface, const QPointF& widget);
    Amount drag(const SolidSurface& surface, const QPointF& widget);
    const Part& part() const { return m_part; }
    Grip grip(const SolidSurface& surface) const;
    /// The amount that a typed number means: a length along the axis, degrees, or a factor.
    Amount typed(double number, const SolidSurface& surface) const;

    void paint(QPainter& painter, const SolidSurface& surface, const std::optional<Part>& lit) const;

  private:
    std::vector<Part> parts() const;
    std::vector<Vec<3>> outline(const Part& part, const SolidSurface& surface) const;
    Vec<3> normalOf(const Part& part, const SolidSurface& surface) const;
    double length(const SolidSurface& surface) const;
    Vec<3> pointAt(const SolidSurface& surface, const QPointF& widget) const;
    double angleAt(const SolidSurface& surface, const QPointF& widget) const;
    double distanceAt(const SolidSurface& surface, const QPointF& widget) const;

    Mode m_mode = Mode::Move;
    Vec<3> m_centre = Vec<3>::Zero();
    Mat<3> m_axes = Mat<3>::Identity();
    Part m_part;
    Vec<3> m_startPoint = Vec<3>::Zero();
    double m_lastAngle = 0, m_angle = 0, m_startDistance = 1;
};

}  // namespace wend
