#include "app/tools/paint/stiffness_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/engine/motion/pose_places.h"
#include "app/engine/shape/material_raster.h"
#include "app/style/colours.h"
#include "app/style/marks.h"

namespace wend {

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

}  // namespace wend
