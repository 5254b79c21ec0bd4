#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <optional>

class QKeyEvent;

namespace wend {

double distanceToLine(const QPointF& p, const QPointF& a, const QPointF& b);

/// What is inside of a line that is drawn; where it crosses itself, too.
QPainterPath insideOf(const QPolygonF& line);
/// What a brush covers along a line.
QPainterPath brushedAlong(const QPolygonF& line, double radius);

/// A rectangle, a lasso or the way of a brush, as it is drawn on the screen to take what lies in it.
class DrawnOutline {
  public:
    enum class Kind { Rectangle, Lasso, Brush };
    explicit DrawnOutline(Kind kind = Kind::Rectangle) : m_kind(kind) {}

    Kind kind() const { return m_kind; }
    void setKind(Kind kind) { m_kind = kind; }
    void begin(const QPointF& at);
    void goOn(const QPointF& at);
    /// The corner of the rectangle is there; the line stays as it was drawn.
    void endAt(const QPointF& at) { m_end = at; }
    QPainterPath area() const;
    bool contains(const QPointF& p) const;
    /// What the brush covers where it came last.
    bool isNewlyBrushed(const QPointF& p) const;
    /// Nothing was drawn: the whole line stayed where it began.
    bool isClick() const;
    /// Of the brush, in pixels.
    void setRadius(double radius) { m_radius = radius; }
    /// What a key makes of it; nothing for another key, or without a brush.
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
