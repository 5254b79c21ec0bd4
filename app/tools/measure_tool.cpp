#include "app/tools/measure_tool.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/engine/motion/pose_places.h"
#include "app/project/domain.h"
#include "app/style/mark_size.h"
#include "app/tools/drag_label.h"

namespace wend {

namespace {

constexpr double kSnap = 5;  // pixels: distance within which a vertex is chosen
const QColor kMeasureColour(0xd4, 0x4a, 0x7a);

template <int Dim>
double length(const std::vector<Vec<Dim>>& p) {
    return (p[1] - p[0]).norm();
}

/// Returns the angle of the unit vectors a and b: 2 arctan(‖a − b‖ / ‖a + b‖), accurate near 0° and 180°.
template <int Dim>
double degrees(const std::vector<Vec<Dim>>& p) {
    const Vec<Dim> a = (p[0] - p[1]).normalized(), b = (p[2] - p[1]).normalized();
    return 2 * std::atan2((a - b).norm(), (a + b).norm()) * 180 / std::numbers::pi;
}

/// The corner of the cell that is nearest to a point of it.
template <int Dim>
Vec<Dim> nearestCorner(const PosedFrame<Dim>& frame, const Touch<Dim>& touch) {
    const Cell<Dim>& cell = frame.rest->cells[touch.place.cell];
    const int nearest = *std::ranges::min_element(
        cell, {}, [&](int v) { return (frame.pose.col(v) - touch.point).squaredNorm(); });
    return frame.pose.col(nearest);
}

}  // namespace

template <int Dim>
QString MeasureTool<Dim>::hint() const {
    const QString measured = text();
    if (!measured.isEmpty()) return measured;
    return QCoreApplication::translate(
        "MeasureTool",
        "Click two points for a length, a third for the angle; Ctrl snaps to vertices, Esc clears");
}

template <int Dim>
void MeasureTool<Dim>::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    const auto touch = surface().touch(event.position());
    const auto frame = session().template frame<Dim>();
    // A click outside the shape only removes a complete measurement.
    if (m_points.size() == 3 || (frame && frame->shape != m_shape)) m_points.clear();
    if (touch && frame) {
        m_shape = frame->shape;
        const Vec<Dim> vertex = nearestCorner<Dim>(*frame, *touch);
        const bool near = QLineF(surface().toWidget(vertex), event.position()).length() <= kSnap;
        const bool snaps = near || event.modifiers() & Qt::ControlModifier;
        m_points.push_back(snaps ? locationIn<Dim>(*frame, touch->place.cell, vertex) : touch->place);
    }
    surface().redraw();
}

template <int Dim>
bool MeasureTool<Dim>::key(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape) return false;
    m_points.clear();
    surface().redraw();
    return true;
}

template <int Dim>
std::vector<Vec<Dim>> MeasureTool<Dim>::pointsIn(const PosedFrame<Dim>& frame,
                                                 const Points<Dim>& points) const {
    std::vector<Vec<Dim>> result;
    result.reserve(m_points.size());
    for (const Location<Dim>& location : m_points)
        result.push_back(positionOf<Dim>(location, *frame.rest, points));
    return result;
}

template <int Dim>
QString MeasureTool<Dim>::text() const {
    const auto frame = session().template frame<Dim>();
    if (!frame || frame->shape != m_shape || m_points.size() < 2) return {};
    const QLocale locale;
    const bool angle = m_points.size() == 3;
    const auto pose = pointsIn(*frame, frame->pose), start = pointsIn(*frame, frame->rest->points);
    const double now = angle ? degrees<Dim>(pose) : length<Dim>(pose);
    const double rest = angle ? degrees<Dim>(start) : length<Dim>(start);
    const bool pixels = session().document().domain().kind == DomainKind::Image;
    const QString unit = angle ? QStringLiteral("°") : pixels ? QStringLiteral(" px") : QString();
    return QCoreApplication::translate("MeasureTool",
                                       angle ? QT_TRANSLATE_NOOP("MeasureTool", "angle %1, at rest %2")
                                             : QT_TRANSLATE_NOOP("MeasureTool", "length %1, at rest %2"))
        .arg(locale.toString(now, 'g', 5) + unit, locale.toString(rest, 'g', 5) + unit);
}

template <int Dim>
void MeasureTool<Dim>::paint(QPainter& painter) const {
    const auto frame = session().template frame<Dim>();
    if (!frame || frame->shape != m_shape) return;
    QPolygonF line;
    for (const Vec<Dim>& p : pointsIn(*frame, frame->pose)) line << surface().toWidget(p);
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

template class MeasureTool<2>;
template class MeasureTool<3>;

ToolKind measureTool() {
    return toolKind("measure", "measure", QT_TRANSLATE_NOOP("Tools", "M&easure"),
                    QT_TRANSLATE_NOOP("Tools", "Measure lengths and angles between points of the shape"),
                    "E; Shift+E", Modes::all().without(Mode::Export), both<MeasureTool>());
}

}  // namespace wend
