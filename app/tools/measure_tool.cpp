#include "app/tools/measure_tool.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/project/domain.h"
#include "app/session/shape_session.h"
#include "app/style/marks.h"
#include "app/tools/drag_label.h"

namespace wend {

namespace {

constexpr double kSnap = 5;  // pixels: distance within which a vertex is chosen
const QColor kMeasureColour(0xd4, 0x4a, 0x7a);

double length(const std::vector<Vec3>& p) {
    return (p[1] - p[0]).norm();
}

/// Returns the angle of the unit vectors a and b: 2 arctan(‖a − b‖ / ‖a + b‖), accurate near 0° and 180°.
double degrees(const std::vector<Vec3>& p) {
    const Vec3 a = (p[0] - p[1]).normalized(), b = (p[2] - p[1]).normalized();
    return 2 * std::atan2((a - b).norm(), (a + b).norm()) * 180 / std::numbers::pi;
}

/// Returns the corner of the touched cell that is nearest to the touched point.
Vec3 nearestCorner(const ShapeFrame& frame, const Touch& touch) {
    return frame.vertex(*std::ranges::min_element(frame.corners(touch.place.cell), {}, [&](int v) {
        return (frame.vertex(v) - touch.point).squaredNorm();
    }));
}

}  // namespace

QString MeasureTool::hint() const {
    const QString measured = text();
    if (!measured.isEmpty()) return measured;
    return QCoreApplication::translate(
        "MeasureTool",
        "Click two points for a length, a third for the angle; Ctrl snaps to vertices, Esc clears");
}

void MeasureTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    const auto touch = view().touch(event.position());
    const FramePtr frame = this->frame();
    // A click outside the shape only removes a complete measurement.
    if (m_points.size() == 3 || (frame && frame->shape != m_shape)) m_points.clear();
    if (touch && frame) {
        m_shape = frame->shape;
        const Vec3 vertex = nearestCorner(*frame, *touch);
        const bool near = QLineF(view().onScreen(vertex), event.position()).length() <= kSnap;
        const bool snaps = near || event.modifiers() & Qt::ControlModifier;
        m_points.push_back(snaps ? frame->placeIn(touch->place.cell, vertex) : touch->place);
    }
    view().redraw();
}

bool MeasureTool::key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape) return false;
    m_points.clear();
    view().redraw();
    return true;
}

std::vector<Vec3> MeasureTool::pointsIn(const ShapeFrame& frame, bool atRest) const {
    std::vector<Vec3> result;
    result.reserve(m_points.size());
    for (const Place& place : m_points) result.push_back(atRest ? frame.restAt(place) : frame.at(place));
    return result;
}

QString MeasureTool::text() const {
    const FramePtr frame = this->frame();
    if (!frame || frame->shape != m_shape || m_points.size() < 2) return {};
    const QLocale locale;
    const bool angle = m_points.size() == 3;
    const auto pose = pointsIn(*frame), start = pointsIn(*frame, true);
    const double now = angle ? degrees(pose) : length(pose);
    const double rest = angle ? degrees(start) : length(start);
    const bool pixels = session().document().domain().kind == DomainKind::Image;
    const QString unit = angle ? QStringLiteral("°") : pixels ? QStringLiteral(" px") : QString();
    return QCoreApplication::translate("MeasureTool",
                                       angle ? QT_TRANSLATE_NOOP("MeasureTool", "angle %1, at rest %2")
                                             : QT_TRANSLATE_NOOP("MeasureTool", "length %1, at rest %2"))
        .arg(locale.toString(now, 'g', 5) + unit, locale.toString(rest, 'g', 5) + unit);
}

void MeasureTool::paint(QPainter& painter) const {
    const FramePtr frame = this->frame();
    if (!frame || frame->shape != m_shape) return;
    QPolygonF line;
    for (const Vec3& p : pointsIn(*frame)) line << view().onScreen(p);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 200), marked(4), Qt::SolidLine, Qt::RoundCap));
    painter.drawPolyline(line);
    painter.setPen(QPen(kMeasureColour, marked(2), Qt::SolidLine, Qt::RoundCap));
    painter.drawPolyline(line);
    painter.setBrush(Qt::white);
    for (const QPointF& p : line) painter.drawEllipse(p, marked(4), marked(4));
    if (text().isEmpty()) return;
    const QPointF at = line.size() == 3 ? line[1] : (line[0] + line[1]) / 2;
    paintLabel(painter, at + QPointF(14, 10), text());
}

ToolKind measureTool() {
    return toolKind("measure", "measure", QT_TRANSLATE_NOOP("Tools", "M&easure"),
                    QT_TRANSLATE_NOOP("Tools", "Measure lengths and angles between points of the shape"),
                    "E; Shift+E", Modes::all().without(Mode::Export), both<MeasureTool>());
}

}  // namespace wend
