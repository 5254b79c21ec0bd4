#include "app/tools/measure_tool.h"

#include <Eigen/Geometry>
#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <numbers>

namespace wend {

namespace {

const QColor kLine(0xd4, 0x4a, 0x7a);

QString said(const char* text) {
    return QCoreApplication::translate("MeasureTool", text);
}

double length(const Points<3>& points, const std::vector<int>& v) {
    return (points.col(v[1]) - points.col(v[0])).norm();
}

double degrees(const Points<3>& points, const std::vector<int>& v) {
    const Vec<3> a = points.col(v[0]) - points.col(v[1]), b = points.col(v[2]) - points.col(v[1]);
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace

QString MeasureTool::hint() const {
    const QString measured = text();
    if (!measured.isEmpty()) return measured;
    return said(QT_TRANSLATE_NOOP(
        "MeasureTool", "Click two points for a length, a third for the angle at the second; Esc clears"));
}

void MeasureTool::press(const QMouseEvent& event) {
    const SolidHit hit = surface().pick(event.position());
    const FramePtr& frame = session().frame();
    if (m_vertices.size() == 3 || hit.vertex < 0 || (frame && frame->shape != m_shape)) m_vertices.clear();
    if (hit.vertex >= 0 && frame) {
        m_shape = frame->shape;
        m_vertices.push_back(hit.vertex);
    }
    surface().redraw();
}

bool MeasureTool::key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape) return false;
    m_vertices.clear();
    surface().redraw();
    return true;
}

QString MeasureTool::text() const {
    const auto frame = session().frame<3>();
    if (!frame || frame->shape != m_shape || m_vertices.size() < 2) return {};
    const QLocale locale;
    const bool angle = m_vertices.size() == 3;
    const double now = angle ? degrees(frame->pose, m_vertices) : length(frame->pose, m_vertices);
    const double rest =
        angle ? degrees(frame->rest->points, m_vertices) : length(frame->rest->points, m_vertices);
    const QString unit = angle ? QStringLiteral("°") : QString();
    return said(angle ? QT_TRANSLATE_NOOP("MeasureTool", "angle %1, at rest %2")
                      : QT_TRANSLATE_NOOP("MeasureTool", "length %1, at rest %2"))
        .arg(locale.toString(now, 'g', 5) + unit, locale.toString(rest, 'g', 5) + unit);
}

void MeasureTool::paint(QPainter& painter) const {
    const auto frame = session().frame<3>();
    if (!frame || frame->shape != m_shape) return;
    QPolygonF line;
    for (const int v : m_vertices) line << surface().toWidget(frame->pose.col(v));
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
