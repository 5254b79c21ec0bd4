#include "app/tools/picture_marks.h"

#include <QLocale>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/engine/motion/places.h"
#include "app/engine/shape/material_raster.h"
#include "app/style/colours.h"
#include "app/style/marks.h"
#include "app/tools/drag_label.h"
#include "core/base/disjoint_sets.h"

namespace wend {

namespace {

constexpr double kHatch = 0.35, kBadge = 18,
                 kSmallestPart = 60;  // opacity; pixels; pixels² of a part with a badge

/// A connected part of one order on the screen.
struct Part {
    float order = 0;
    double area = 0;
    QPointF weighted;
    std::vector<int> cells;
};

QPolygonF triangleOf(const PosedFrame<2>& frame, int cell,
                     const std::function<QPointF(const Vec2&)>& toWidget) {
    QPolygonF triangle;
    for (const int v : frame.rest->cells[static_cast<std::size_t>(cell)])
        triangle << toWidget(frame.pose.col(v));
    return triangle;
}

double areaOf(const QPolygonF& t) {
    const QPointF u = t[1] - t[0], v = t[2] - t[0];
    return std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
}

/// Draws a badge at the origin.
void paintBadge(QPainter& painter, float order) {
    const QString text = (order > 0 ? QStringLiteral("▲") : QStringLiteral("▼")) +
                         QLocale().toString(std::abs(double(order)), 'g', 3);
    const double width = std::max(kBadge, painter.fontMetrics().horizontalAdvance(text) + 8.0);
    const QRectF box(-width / 2, -kBadge / 2, width, kBadge);
    painter.setPen(QPen(QColor(255, 255, 255, 217), 1.5));
    painter.setBrush(order > 0 ? QColor(kAccent) : QColor(kBehind));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace

void paintDepths(QPainter& painter, const PosedFrame<2>& frame, const std::vector<float>& depths,
                 const std::function<QPointF(const Vec2&)>& toWidget) {
    if (depths.empty()) return;
    const auto order = [&](int cell) { return depths[static_cast<std::size_t>(cell)]; };
    DisjointSets sets(frame.rest->cellCount());
    for (const auto& facet : facetsOf(*frame.rest))
        if (facet.interior() && order(facet.cells[0]) == order(facet.cells[1]))
            sets.join(facet.cells[0], facet.cells[1]);
    std::map<int, Part> parts;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);  // neighbours share no pixel
    painter.setPen(Qt::NoPen);
    for (int cell = 0; cell < frame.rest->cellCount(); ++cell) {
        if (order(cell) == 0) continue;
        const QPolygonF triangle = triangleOf(frame, cell, toWidget);
        QColor colour(order(cell) > 0 ? kAccent : kBehind);
        colour.setAlphaF(kHatch);
        painter.setBrush(QBrush(colour, order(cell) > 0 ? Qt::BDiagPattern : Qt::FDiagPattern));
        painter.drawPolygon(triangle);
        Part& part = parts[sets.root(cell)];
        const double area = areaOf(triangle);
        part.order = order(cell);
        part.area += area;
        part.weighted += area * (triangle[0] + triangle[1] + triangle[2]) / 3;
        part.cells.push_back(cell);
    }
    painter.restore();
    for (const auto& [root, part] : parts) {
        if (part.area < kSmallestPart) continue;
        // The centroid of a part may be outside of it.
        const QPointF middle = part.weighted / part.area;
        QPointF best;
        double nearest = std::numeric_limits<double>::infinity();
        for (const int cell : part.cells) {
            const QPolygonF t = triangleOf(frame, cell, toWidget);
            const QPointF centre = (t[0] + t[1] + t[2]) / 3;
            if (const double d = QLineF(centre, middle).length(); d < nearest) nearest = d, best = centre;
        }
        enlarged(painter, best, [&] { paintBadge(painter, part.order); });
    }
}

namespace {

constexpr double kMarkGrid = 40;                  // pixels of the screen
constexpr double kLeastStiffness = 1.05;          // less shows no direction
constexpr double kShortAxis = 6, kLongAxis = 18;  // pixels, half of the long axis
constexpr double kLongAt = 100;                   // the ratio where it does not grow any more

}  // namespace

double markLength(double ratio) {
    return marked(kShortAxis +
                  (kLongAxis - kShortAxis) * std::clamp(std::log(ratio) / std::log(kLongAt), 0.0, 1.0));
}

void paintStiffnessMarks(QPainter& painter, PictureShapeView& view, const QSize& size) {
    const auto frame = posed<2>(view.shownFrame());
    if (!frame || frame->material->anisotropy.empty()) return;
    QColor fill(kStiffColour);
    fill.setAlphaF(0.25F);
    const double grid = marked(kMarkGrid);
    for (double y = grid / 2; y < size.height(); y += grid)
        for (double x = grid / 2; x < size.width(); x += grid) {
            const auto touch = view.touch(QPointF(x, y));
            if (!touch) continue;
            const int cell = touch->place.cell;
            const Stiffness stiffness = stiffnessOf<2>(frame->material->anisotropy[cell]);
            if (stiffness.ratio < kLeastStiffness) continue;
            const Vec3 along = frame->rotationOf(cell) * stiffness.axis;
            // The view may show the domain mirrored.
            const QPointF way = view.onScreen(touch->point + along) - view.onScreen(touch->point);
            const double a = markLength(stiffness.ratio),
                         b = std::max(marked(2.5), a / std::sqrt(stiffness.ratio));
            painter.save();
            painter.translate(x, y);
            painter.rotate(std::atan2(way.y(), way.x()) * 180 / std::numbers::pi);
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(QColor(255, 255, 255, 217), marked(3.5)));
            painter.drawEllipse(QPointF(), a, b);
            painter.setPen(QPen(QColor(kStiffColour), marked(1.5)));
            painter.setBrush(fill);
            painter.drawEllipse(QPointF(), a, b);
            painter.restore();
        }
}

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

void paintVelocityArrows(QPainter& painter, PictureShapeView& view, const Points2& velocity,
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
            Vec2 v = Vec2::Zero();
            for (int k = 0; k < 3; ++k) v += touch->place.weights[k] * velocity.col(cell[k]);
            // The view may show the domain mirrored.
            const Vec3 step = inSpace(Vec2(v / fastest * view.pixelSize(touch->point) * marked(kLong)));
            const QPointF way = view.onScreen(touch->point + step) - view.onScreen(touch->point);
            if (std::hypot(way.x(), way.y()) >= marked(kShortestArrow))
                paintArrow(painter, QPointF(x, y), way);
        }
}

}  // namespace wend
