#pragma once

#include <QPainter>
#include <array>
#include <functional>
#include <vector>

#include "core/motion/handle.h"

namespace wend {

inline constexpr double kPinRadius = 6.5;
/// Of what the shape covers: pins, stiffness marks, wrong triangles.
inline constexpr double kCoveredOpacity = 0.4;
inline const QColor kInk(20, 22, 30);
/// Of what is wrong with a surface or a pose.
inline constexpr QRgb kWrong = qRgb(214, 44, 60);

/// The colours that pins have without being given one; told apart by lightness too.
const std::array<QColor, 8>& pinColours();
/// By which a pin is known in the list and on the shape.
QColor pinColour(int handle, const HandleTraits& traits);

/// The marks that lie over pictures and solids alike, at places of the widget: light-rimmed, so that they
/// show on any ground. Their size is what the user has chosen, see mark_size.h.
class Marks {
  public:
    explicit Marks(QPainter& painter) : m_painter(painter) {}

    /// While a shape follows the hand, lines are thin and have no rim: they leave their time to the shape.
    void setQuick(bool quick) { m_quick = quick; }
    void line(const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style);
    /// The way of a handle, with a dot each tenth of a second, a larger one each second.
    /// What has been gone is solid, what is to come dashed.
    void path(const QPolygonF& line, const std::vector<double>& times, bool selected, double now,
              bool hovered = false);
    struct Pin {
        bool selected = false, hovered = false;
        bool region = false;  // a rounded square
        bool moves = true;    // of one that only holds, the disc is dark
        QColor colour = QColor(0x3a3d47);
        bool locked = false;  // bears a padlock
    };
    void pin(const QPointF& at, const Pin& look);
    /// A handle that is let go of, or yet to come: an empty, dashed ring.
    void ghost(const QPointF& at, bool selected, bool hovered);
    void name(const QPointF& at, const QString& text);
    /// Small discs of one look, many of them: drawn once and copied.
    void spots(const std::vector<QPointF>& places, const QColor& fill, double radius, QPen rim);
    /// A cross of hairs; of a hidden place a faint ring alone: what is seen there is something else.
    void worst(const QPointF& at, bool hidden = false);

  private:
    void enlarged(const QPointF& at, const std::function<void()>& draw);
    void drawPin(const QPointF& at, const Pin& look);
    void drawGhost(const QPointF& at, bool selected, bool hovered);
    void drawName(const QPointF& at, const QString& text);
    void drawWorst(const QPointF& at, bool hidden);
    void halo(const QPolygonF& line, double width);
    void padlock(const QPointF& at);
    void hairline(const QPolygonF& line, const QColor& colour);

    QPainter& m_painter;
    bool m_quick = false;
};

}  // namespace wend
