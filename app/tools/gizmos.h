#pragma once

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <numbers>
#include <optional>

#include "app/project/edits/grip.h"
#include "app/tools/shape_view.h"

namespace wend {

/// The dragged part of a gizmo. The default moves the pins in the plane of the screen.
struct GizmoPart {
    Grip::Kind kind = Grip::Kind::Move;
    int axis = -1;       // −1: none
    bool plane = false;  // moves in the plane across the axis

    bool operator==(const GizmoPart&) const = default;
};

/// A control around a point that is dragged to move, rotate or scale: a ring in a picture, a manipulator in
/// space. Its size on the screen is constant.
class Gizmo {
  public:
    using Part = GizmoPart;
    virtual ~Gizmo() = default;

    /// `canTurn`: false around a single point, which is widened before it rotates or scales.
    void place(const Vec3& centre, bool canTurn) {
        m_centre = centre;
        m_canTurn = canTurn;
        takePlace();
    }
    const Vec3& centre() const { return m_centre; }
    bool canTurn() const { return m_canTurn; }
    const Part& part() const { return m_part; }
    virtual void setGrip(Grip::Kind kind) = 0;
    /// Returns whether parts take precedence over pins below them, rather than pins over parts.
    virtual bool comesFirst() const = 0;
    /// Returns the part that a drag from anywhere uses; none if pins are moved directly.
    virtual std::optional<Part> anywhere() const { return {}; }
    /// Returns the part under the pointer.
    virtual std::optional<Part> partAt(const ShapeView& view, const QPointF& widget) const = 0;
    /// Returns true if a drag from here rotates a single point.
    virtual bool turnsPointAt(const ShapeView&, const QPointF&) const { return false; }
    /// Returns the hint over a part.
    virtual QString hint() const = 0;

    /// Starts a drag, which drag() measures from here; the centre stays until the end.
    virtual void begin(const Part& part, const ShapeView& view, const QPointF& widget) = 0;
    virtual Grip grip(const ShapeView& view) const = 0;
    /// `snaps`: angles to 15°, displacements in a plane to one of its axes.
    virtual Amount drag(const ShapeView& view, const QPointF& widget, bool snaps = false) = 0;
    /// Returns the amount that a typed number means: a length along the axis, degrees, or a factor.
    virtual Amount typed(double number, const ShapeView& view) const = 0;

    virtual void paint(QPainter& painter, const ShapeView& view, const std::optional<Part>& lit) const = 0;
    /// Draws the gizmo during a drag.
    virtual void paintDragged(QPainter& painter, const ShapeView& view, const Amount& amount) const = 0;

    /// Returns the text beside the pointer; `dimension`: how many coordinates a displacement has.
    QString text(const Amount& amount, int dimension) const {
        const QLocale locale;
        if (m_part.kind == Grip::Kind::Turn)
            return locale.toString(amount[0] * 180 / std::numbers::pi, 'f', 1) + QStringLiteral("°");
        if (m_part.kind == Grip::Kind::Grow)
            return QStringLiteral("×") + locale.toString(1 + amount[0], 'f', 2);
        QString all;
        for (int k = 0; k < dimension; ++k)
            all += (k > 0 ? QStringLiteral("  ") : QString()) + locale.toString(amount[k], 'g', 4);
        return all;
    }

  protected:
    static constexpr double kAngleStep = std::numbers::pi / 12;  // of a rotation with Shift

    virtual void takePlace() {}
    bool isAlongAxis() const { return m_part.axis >= 0 && !m_part.plane; }
    /// Returns the amount of a typed number of degrees, or of a factor.
    Amount turnedOrScaled(double number) const {
        constexpr double kMinFactor = 0.01;
        if (m_part.kind == Grip::Kind::Turn) return {number * std::numbers::pi / 180, 0, 0};
        return {std::max(number, kMinFactor) - 1, 0, 0};
    }

    Vec3 m_centre = Vec3::Zero();
    bool m_canTurn = true;
    Part m_part;
};

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
    /// Applies a typed length along the axis, or else in the direction of the drag.
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

/// A manipulator around a point of a solid: arrows, squares, rings and a disc.
class Manipulator : public Gizmo {
  public:
    /// Tilt: an arrow along the third axis and rings around the first two, for a plane.
    enum class Mode { Move, Turn, Grow, Tilt };
    void setMode(Mode mode) { m_mode = mode; }
    void setGrip(Grip::Kind kind) override;
    bool comesFirst() const override { return true; }
    using Gizmo::place;
    /// Places the manipulator with the columns of `axes` as its axes.
    void place(const Vec3& centre, const Mat3& axes);
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
    Mat3 m_axes = Mat3::Identity();
    Vec3 m_startPoint = Vec3::Zero();
    double m_lastAngle = 0, m_angle = 0, m_startDistance = 1;
};

}  // namespace wend
