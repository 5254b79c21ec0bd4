#pragma once

#include <QPainter>
#include <vector>

namespace wend {

inline constexpr double kPinRadius = 6.5;
inline const QColor kInk(20, 22, 30);

/// The marks that lie over pictures and solids alike, at places of the widget: light-rimmed, so that they
/// show on any ground.
class Marks {
  public:
    explicit Marks(QPainter& painter) : m_painter(painter) {}

    void line(const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style);
    /// The way of a handle, with ticks at equal steps of time: filled where the shape has been already.
    void path(const QPolygonF& line, const std::vector<double>& times, bool selected, double now);
    /// `square`: of a whole region.
    void pin(const QPointF& at, bool selected, bool hovered, bool square);
    void name(const QPointF& at, const QString& text);
    /// A cross of hairs; of a hidden place a faint ring alone: what is seen there is something else.
    void worst(const QPointF& at, bool hidden = false);

  private:
    QPainter& m_painter;
};

}  // namespace wend
