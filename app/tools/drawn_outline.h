#pragma once

#include <QPainter>
#include <QPolygonF>

class QKeyEvent;

namespace wend {

/// A rectangle, a lasso or the way of a brush, as it is drawn on the screen to take what lies in it.
class DrawnOutline {
  public:
    enum class Kind { Rectangle, Lasso, Brush };

    Kind kind() const { return m_kind; }
    void setKind(Kind kind) { m_kind = kind; }
    void begin(const QPointF& at);
    void goOn(const QPointF& at);
    /// The corner of the rectangle is there; the line stays as it was drawn.
    void endAt(const QPointF& at) { m_end = at; }
    bool contains(const QPointF& p) const;
    /// True if the key has changed the size of the brush.
    bool key(const QKeyEvent& event);
    void paint(QPainter& painter) const;
    void paintBrush(QPainter& painter, const QPointF& at) const;

  private:
    Kind m_kind = Kind::Rectangle;
    QPolygonF m_line;
    QPointF m_end;
    double m_radius = 18;  // of the brush, in pixels
};

}  // namespace wend
