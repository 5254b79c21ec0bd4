#include "app/tools/paint/depth_marks.h"

#include <QLocale>
#include <QPainterPath>
#include <cmath>
#include <map>

#include "app/style/colours.h"
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
                     const std::function<QPointF(const Vec<2>&)>& toWidget) {
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
                 const std::function<QPointF(const Vec<2>&)>& toWidget) {
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

}  // namespace wend
