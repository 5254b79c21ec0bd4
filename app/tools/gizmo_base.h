#pragma once

#include <QLocale>
#include <QString>
#include <algorithm>
#include <numbers>

#include "app/project/edits/grip.h"

namespace wend {

/// The dragged part of a gizmo. The default moves the pins in the plane of the screen.
struct GizmoPart {
    Grip::Kind kind = Grip::Kind::Move;
    int axis = -1;       // −1: none
    bool plane = false;  // moves in the plane across the axis

    bool operator==(const GizmoPart&) const = default;
};

/// Common parts of the 2D ring and the 3D manipulator: the place, the dragged part and its numbers.
template <int Dim>
class GizmoBase {
  public:
    using Part = GizmoPart;

    /// `canTurn`: false around a single point, which is widened before it rotates or scales.
    void place(const Vec<Dim>& centre, bool canTurn) {
        m_centre = centre;
        m_canTurn = canTurn;
    }
    const Vec<Dim>& centre() const { return m_centre; }
    bool canTurn() const { return m_canTurn; }
    const Part& part() const { return m_part; }
    /// Returns the text beside the pointer.
    QString text(const Amount& amount) const {
        const QLocale locale;
        if (m_part.kind == Grip::Kind::Turn)
            return locale.toString(amount[0] * 180 / std::numbers::pi, 'f', 1) + QStringLiteral("°");
        if (m_part.kind == Grip::Kind::Grow)
            return QStringLiteral("×") + locale.toString(1 + amount[0], 'f', 2);
        QString all;
        for (int k = 0; k < Dim; ++k)
            all += (k > 0 ? QStringLiteral("  ") : QString()) + locale.toString(amount[k], 'g', 4);
        return all;
    }

  protected:
    static constexpr double kAngleStep = std::numbers::pi / 12;  // of a rotation with Shift

    bool isAlongAxis() const { return m_part.axis >= 0 && !m_part.plane; }
    /// Returns the amount of a typed number of degrees, or of a factor.
    Amount turnedOrScaled(double number) const {
        constexpr double kMinFactor = 0.01;
        if (m_part.kind == Grip::Kind::Turn) return {number * std::numbers::pi / 180, 0, 0};
        return {std::max(number, kMinFactor) - 1, 0, 0};
    }

    Vec<Dim> m_centre = Vec<Dim>::Zero();
    bool m_canTurn = true;
    Part m_part;
};

}  // namespace wend
