#include "app/tools/measure_tool.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <numbers>

#include "app/session/solid_places.h"

namespace wend {

namespace {

constexpr double kSnap = 5;  // pixels: a vertex that near is meant
const QColor kLine(0xd4, 0x4a, 0x7a);

QString said(const char* text) {
    return QCoreApplication::translate("MeasureTool", text);
}

double length(const std::vector<Vec<3>>& p) {
    return (p[1] - p[0]).norm();
}

double degrees(const std::vector<Vec<3>>& p) {
    const Vec<3> a = p[0] - p[1], b = p[2] - p[1];
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace

QString MeasureTool::hint() const {
    const QString measured = text();
    if (!measured.isEmpty()) return measured;
    return said(QT_TRANSLATE_NOOP(
        "MeasureTool",
        "Click two points for a length, a third for the angle; Ctrl takes vertices, Esc clears"));
}

void MeasureTool::press(const QMouseEvent& event) {
    const SolidHit hit = surface().pick(event.position());
    const auto frame = session().frame<3>();
    // A click beside the solid drops only what is complete.
    if (m_points.size() == 3 || (frame && frame->shape != m_shape)) m_points.clear();
    if (hit.cell >= 0 && hit.vertex >= 0 && frame) {
        m_shape = frame->shape;
        const Vec<3> vertex = frame->pose.col(hit.vertex);
        const bool near = QLineF(surface().toWidget(vertex), event.position()).length() <= kSnap;
        const bool snaps = near || event.modifiers() & Qt::ControlModifier;
        m_points.push_back(locationIn<3>(*frame, hit.cell, snaps ? vertex : hit.point));
    }
    surface().redraw();
}

bool MeasureTool::key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape) return false;
    m_points.clear();
    surface().redraw();
    return true;
}

std::vector<Vec<3>> MeasureTool::pointsIn(const PosedFrame<3>& frame, const Points<3>& points) const {
    std::vector<Vec<3>> result;
    result.reserve(m_points.size());
    for (const Location<3>& location : m_points)
        result.push_back(positionOf<3>(location, *frame.rest, points));
    return result;
}

QString MeasureTool::text() const {
    const auto frame = session().frame<3>();
    if (!frame || frame->shape != m_shape || m_points.size() < 2) return {};
    const QLocale locale;
    const bool angle = m_points.size() == 3;
    const auto pose = pointsIn(*frame, frame->pose), start = pointsIn(*frame, frame->rest->points);
    const double now = angle ? degrees(pose) : length(pose);
    const double rest = angle ? degrees(start) : length(start);
    const QString unit = angle ? QStringLiteral("°") : QString();
    return said(angle ? QT_TRANSLATE_NOOP("MeasureTool", "angle %1, at rest %2")
                      : QT_TRANSLATE_NOOP("MeasureTool", "length %1, at rest %2"))
        .arg(locale.toString(now, 'g', 5) + unit, locale.toString(rest, 'g', 5) + unit);
}

void MeasureTool::paint(QPainter& painter) const {
    const auto frame = session().frame<3>();
    if (!frame || frame->shape != m_shape) return;
    QPolygonF line;
    for (const Vec<3>& p : pointsIn(*frame, frame->pose)) line << surface().toWidget(p);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 200), 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawPolyline(line);
    painter.setPen(QPen(kLine, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawPolyline(line);
    painter.setBrush(Qt::white);
    for (const QPointF& p : line) painter.drawEllipse(p, 4, 4);
    if (text().isEmpty()) return;
    const QPointF at = line.size() == 3 ? line[1] : (line[0] + line[1]) / 2;
    const QRectF box(at + QPointF(14, 10), QSizeF(painter.fontMetrics().horizontalAdvance(text()) + 16, 24));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(28, 30, 38, 225));
    painter.drawRoundedRect(box, 5, 5);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text());
}

}  // namespace wend
