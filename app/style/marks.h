#pragma once

#include <QPainter>
#include <array>
#include <functional>
#include <vector>

#include "core/motion/handle.h"

namespace wend {

struct PinTraits;

/// Scale of all marks over a shape (pins, rings, curves, arrows, labels, tool lines) and of their hit areas.
/// Chosen by the user for all views.
double markSize();
void setMarkSize(double factor);

/// Returns the length of a mark that is given in pixels of the screen for the usual size.
inline double marked(double pixels) {
    return pixels * markSize();
}

inline constexpr double kPinRadius = 6.5;
/// Opacity of covered pins, stiffness marks and faulty triangles.
inline constexpr double kCoveredOpacity = 0.4;
inline const QColor kInk(20, 22, 30);
/// Colour of faults of a surface or a pose.
inline constexpr QRgb kWrong = qRgb(214, 44, 60);

/// Returns the default colours of pins, which lightness alone distinguishes as well.
const std::array<QColor, 8>& pinColours();
/// Returns the colour of a pin in the list and on the shape.
QColor pinColour(int handle, const PinTraits& traits);

/// Marks over pictures and solids, in widget coordinates, with a light rim so that they show on any
/// background. The user sets their size, see markSize().
class Marks {
  public:
    explicit Marks(QPainter& painter) : m_painter(painter) {}

    /// Makes lines thin and without rim during a drag, to leave time for the shape.
    void setQuick(bool quick) { m_quick = quick; }
    void line(const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style);
    /// Draws the path of a handle with a dot per tenth of a second and a larger one per second. The past is
    /// solid, the future dashed.
    void path(const QPolygonF& line, const std::vector<double>& times, bool selected, double now,
              bool hovered = false);
    struct Pin {
        bool selected = false, hovered = false;
        bool region = false;  // a rounded square
        bool moves = true;    // of one that only holds, the disc is dark
        QColor colour = QColor(0x3a3d47);
        bool locked = false;  // draws a padlock
    };
    void pin(const QPointF& at, const Pin& look);
    /// Draws an inactive handle: an empty, dashed ring.
    void ghost(const QPointF& at, bool selected, bool hovered);
    void name(const QPointF& at, const QString& text);
    /// Small discs of one look, many of them: drawn once and copied.
    void spots(const std::vector<QPointF>& places, const QColor& fill, double radius, QPen rim);
    /// Draws a crosshair; for a hidden place only a faint ring, because something else is visible there.
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
