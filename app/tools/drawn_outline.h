#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <optional>

class QKeyEvent;

namespace wend {

double distanceToLine(const QPointF& p, const QPointF& a, const QPointF& b);

/// Returns the inside of a drawn line, including where it crosses itself.
QPainterPath insideOf(const QPolygonF& line);
/// Returns the area that a brush covers along a line.
QPainterPath brushedAlong(const QPolygonF& line, double radius);

/// A marquee: a rectangle, a lasso or a brush stroke on the screen that selects what is inside.
class DrawnOutline {
  public:
    enum class Kind { Rectangle, Lasso, Brush };
    explicit DrawnOutline(Kind kind = Kind::Rectangle) : m_kind(kind) {}

    Kind kind() const { return m_kind; }
    void setKind(Kind kind) { m_kind = kind; }
    void begin(const QPointF& at);
    void goOn(const QPointF& at);
    /// Moves the corner of a rectangle; the line of a lasso stays unchanged.
    void endAt(const QPointF& at) { m_end = at; }
    QPainterPath area() const;
    bool contains(const QPointF& p) const;
    /// Returns whether the brush's last segment covers the point.
    bool isNewlyBrushed(const QPointF& p) const;
    /// Returns whether the whole line stayed at its start.
    bool isClick() const;
    /// Sets the radius of the brush in pixels.
    void setRadius(double radius) { m_radius = radius; }
    /// Returns the radius after a key, or nothing for other keys and without a brush.
    std::optional<double> radiusAfter(const QKeyEvent& event) const;
    void paint(QPainter& painter) const;
    void paintBrush(QPainter& painter, const QPointF& at) const;

  private:
    QRectF box() const { return QRectF(m_line.first(), m_end).normalized(); }

    Kind m_kind;
    QPolygonF m_line;
    QPointF m_end;
    double m_radius = 18;
};

}  // namespace wend
