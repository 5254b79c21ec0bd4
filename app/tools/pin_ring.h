#pragma once

#include <QPainter>
#include <functional>
#include <optional>

#include "app/document/grip.h"

namespace wend {

/// The ring around what is selected in a picture, of constant size on the screen: its dot is dragged to
/// rotate, its square to scale. Around a single point, which can do neither, it is dotted.
class PinRing {
  public:
    enum class Part { Rotate, Scale };
    using ToShape = std::function<Vec<2>(const QPointF&)>;

    /// Around a place of the widget, and of the shape.
    void place(const QPointF& widget, const Vec<2>& shape, bool canTurn);
    bool canTurn() const { return m_canTurn; }
    std::optional<Part> partAt(const QPointF& widget) const;
    /// True on the ring itself.
    bool isOn(const QPointF& widget) const;

    void begin(Part part, const QPointF& widget, const ToShape& toShape);
    Part part() const { return m_part; }
    Grip grip() const;
    /// How far the pointer has brought it; `snaps`: by 15°.
    Amount drag(const QPointF& widget, const ToShape& toShape, bool snaps);
    /// Degrees, or a factor.
    Amount typed(double number) const;
    /// The number that stands at the pointer.
    QString text(const Amount& amount) const;

    void paint(QPainter& painter, const std::optional<Part>& lit) const;

  private:
    QPointF spot(Part part) const;
    std::optional<double> angleAt(const QPointF& widget, const ToShape& toShape) const;

    QPointF m_at;
    Vec<2> m_centre = Vec<2>::Zero();
    bool m_canTurn = false;
    Part m_part = Part::Rotate;
    std::optional<double> m_lastAngle;  // none while the pointer has not left the middle
    double m_angle = 0, m_lead = 0, m_startDistance = 1, m_turned = 0;
};

}  // namespace wend
