#include "app/tools/velocity_arrows.h"

#include <algorithm>
#include <cmath>

#include "app/style/marks.h"

namespace wend {

namespace {

constexpr double kArrowGrid = 32;     // pixels of the screen
constexpr double kLong = 30;          // the fastest one's length
constexpr double kShortestArrow = 2;  // less is no arrow
constexpr double kHead = 6;
const QColor kColour(54, 84, 196);

void paintArrow(QPainter& painter, const QPointF& from, const QPointF& way) {
    const double length = std::hypot(way.x(), way.y());
    const QPointF along = way / length, across(-along.y(), along.x()), tip = from + way;
    const double head = std::min(marked(kHead), 0.6 * length);
    const QPointF neck = tip - head * along;
    const QList<QLineF> lines{
        {from, tip}, {tip, neck + 0.5 * head * across}, {tip, neck - 0.5 * head * across}};
    for (const QPen& pen : {QPen(QColor(255, 255, 255, 217), marked(3.5), Qt::SolidLine, Qt::RoundCap),
                            QPen(kColour, marked(1.5), Qt::SolidLine, Qt::RoundCap)}) {
        painter.setPen(pen);
        painter.drawLines(lines);
    }
}

}  // namespace

void paintVelocityArrows(QPainter& painter, PictureShapeView& view, const Points<2>& velocity,
                         const QSize& size) {
    const FramePtr frame = view.shownFrame();
    if (!frame || velocity.cols() != frame->vertices) return;
    const double fastest = velocity.colwise().norm().maxCoeff();
    if (!(fastest > 0)) return;
    const double grid = marked(kArrowGrid);
    for (double y = grid / 2; y < size.height(); y += grid)
        for (double x = grid / 2; x < size.width(); x += grid) {
            const auto touch = view.touch(QPointF(x, y));
            if (!touch) continue;
            const auto cell = frame->corners(touch->place.cell);
            Vec<2> v = Vec<2>::Zero();
            for (int k = 0; k < 3; ++k) v += touch->place.weights[k] * velocity.col(cell[k]);
            // The view may show the domain mirrored.
            const Vec3 step = inSpace(Vec<2>(v / fastest * view.pixelSize(touch->point) * marked(kLong)));
            const QPointF way = view.onScreen(touch->point + step) - view.onScreen(touch->point);
            if (std::hypot(way.x(), way.y()) >= marked(kShortestArrow))
                paintArrow(painter, QPointF(x, y), way);
        }
}

}  // namespace wend
