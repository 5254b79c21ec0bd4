#include "app/tools/hold_tool.h"

#include <QCoreApplication>
#include <QPainterPathStroker>
#include <algorithm>
#include <cmath>

#include "app/document/design.h"
#include "app/document/handle_edits.h"
#include "app/session/accent.h"
#include "app/session/mark_size.h"
#include "app/session/solid_places.h"
#include "app/tools/region_outline.h"

namespace wend {

namespace {

constexpr double kLargestBrush = 200;  // pixels
constexpr double kDetail = 0.75;       // pixels of the screen that an outline may deviate
constexpr double kLongestEdge = 12;    // pixels of the screen: the shape may be bent under it
constexpr int kMinHeld = 3;            // vertices

QString said(const char* text) {
    return QCoreApplication::translate("HoldTool", text);
}

double sizeOf(const QPolygonF& polygon) {
    double twice = 0;
    for (qsizetype i = 0; i < polygon.size(); ++i) {
        const QPointF &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice) / 2;
}

/// The largest piece of an area, without its holes.
QPolygonF outlineOf(const QPainterPath& area) {
    QPolygonF best;
    for (const QPolygonF& piece : area.simplified().toSubpathPolygons())
        if (sizeOf(piece) > sizeOf(best)) best = piece;
    return best;
}

/// The same outline with no edge longer than kLongestEdge.
QPolygonF refined(const QPolygonF& outline) {
    QPolygonF result;
    for (qsizetype i = 0; i < outline.size(); ++i) {
        const QPointF a = outline[i], b = outline[(i + 1) % outline.size()];
        const int pieces = std::max(1, static_cast<int>(std::ceil(QLineF(a, b).length() / kLongestEdge)));
        for (int k = 0; k < pieces; ++k) result << a + (b - a) * k / pieces;
    }
    return result;
}

/// On half pixels, so that edges that nearly coincide are the same: of such paths unions lose parts.
QPainterPath snapped(const QPainterPath& path) {
    QPainterPath result;
    result.setFillRule(Qt::WindingFill);
    for (QPolygonF piece : path.simplified().toSubpathPolygons()) {
        for (QPointF& p : piece) p = QPointF(std::round(2 * p.x()), std::round(2 * p.y())) / 2;
        result.addPolygon(piece);
        result.closeSubpath();
    }
    return result;
}

QPainterPath pathOf(const QPolygonF& polygon) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

}  // namespace

QString HoldTool::hint() const {
    if (m_shape == Shape::Lasso)
        return said(QT_TRANSLATE_NOOP(
            "HoldTool", "Draw around the part to hold; Shift adds to the selected part, Ctrl takes away"));
    if (m_shape == Shape::Brush)
        return said(QT_TRANSLATE_NOOP(
            "HoldTool", "Brush over the part to hold, [ and ] change the size; Shift adds, Ctrl takes away"));
    return said(QT_TRANSLATE_NOOP(
        "HoldTool",
        "Draw a rectangle over the part to hold; Shift adds to the selected part, Ctrl takes away"));
}

void HoldTool::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    m_at = event.position();
    m_line = {m_at};
    m_active = m_over = true;
    m_surface.redraw();
}

void HoldTool::move(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    if (m_active) m_line << m_at;
    m_surface.redraw();
}

bool HoldTool::isClick() const {
    return m_shape != Shape::Brush && std::all_of(m_line.begin(), m_line.end(), [this](const QPointF& p) {
               return QLineF(m_line.first(), p).length() < 4;
           });
}

QPainterPath HoldTool::area() const {
    QPainterPath path;
    if (m_shape == Shape::Rectangle) {
        path.addRect(QRectF(m_line.first(), m_at).normalized());
        return path;
    }
    if (m_shape == Shape::Lasso) return pathOf(m_line);
    path.addEllipse(m_line.first(), m_radius, m_radius);
    QPainterPath way(m_line.first());
    for (const QPointF& p : m_line) way.lineTo(p);
    QPainterPathStroker stroker;
    stroker.setWidth(2 * m_radius);
    stroker.setCapStyle(Qt::RoundCap);
    stroker.setJoinStyle(Qt::RoundJoin);
    return m_line.size() > 1 ? path.united(stroker.createStroke(way).simplified()) : path;
}

/// Of the one selected handle; empty if that is no part.
QPainterPath HoldTool::selectedArea() const {
    const int handle = session().singleHandle();
    const auto frame = session().frame<2>();
    if (handle < 0 || !frame) return {};
    for (const PinView<2>& view : session().pins()) {
        if (view.handle != handle || !view.region) continue;
        QPolygonF border;
        for (const Vec<2>& p : regionBorder(session().document().design<2>().handles[handle], view, *frame))
            border << m_surface.toWidget(p);
        return pathOf(border);
    }
    return {};
}

/// Where the outline lies on the shape at rest: beside the shape as far from the nearest vertex as now.
Polygon HoldTool::atRest(const QPolygonF& outline) const {
    const auto frame = session().frame<2>();
    const PointLocator<2> locator(frame->pose, frame->rest->cells);
    const Points<2>& rest = frame->rest->points;
    std::vector<Vec<2>> points;
    for (const QPointF& corner : refined(outline)) {
        const Vec<2> p = m_surface.toShape(corner);
        if (const auto location = locator.find(p)) {
            points.push_back(positionOf<2>(*location, *frame->rest, rest));
            continue;
        }
        Eigen::Index nearest = 0;
        (frame->pose.colwise() - p).colwise().squaredNorm().minCoeff(&nearest);
        points.push_back(rest.col(nearest) + p - frame->pose.col(nearest));
    }
    const double pixel = (m_surface.toShape({1, 0}) - m_surface.toShape({0, 0})).norm();
    points.push_back(points.front());
    points = simplified<2>(points, kDetail * pixel);
    points.pop_back();
    return {points};
}

bool HoldTool::holdsSomething(const Polygon& polygon) const {
    const auto held = verticesInside<2>(Region<2>(polygon), *session().frame<2>()->rest);
    if (static_cast<int>(held.size()) >= kMinHeld) return true;
    emit session().notice(
        said(QT_TRANSLATE_NOOP("HoldTool", "There is nothing of the shape in this outline.")));
    return false;
}

void HoldTool::hold(const QPainterPath& area) {
    const QPolygonF outline = outlineOf(area);
    if (outline.size() < 3) return;
    const Polygon polygon = atRest(outline);
    if (polygon.points.size() < 3 || !holdsSomething(polygon)) return;
    session().addHandle<2>(Region<2>(polygon), said(QT_TRANSLATE_NOOP("HoldTool", "Part")).toStdString());
    m_done();
}

void HoldTool::change(const QPainterPath& area) {
    const QPolygonF outline = outlineOf(area);
    const Polygon polygon = outline.size() < 3 ? Polygon{} : atRest(outline);
    if (polygon.points.size() < 3 || !holdsSomething(polygon)) return;
    const int handle = session().singleHandle();
    if (!session().mayChange(handle)) return;
    Document& document = session().document();
    const QString name = QString::fromStdString(document.design<2>().handles[handle].name);
    document.changeDesign(QCoreApplication::translate("HoldTool", "Change %1").arg(name),
                          withHandlePlace<2>(document.design<2>(), handle, Region<2>(polygon)));
}

void HoldTool::release(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton || !std::exchange(m_active, false)) return;
    m_at = event.position();
    m_line << m_at;
    const QPainterPath drawn = snapped(area()), own = snapped(selectedArea());
    const bool adds = event.modifiers() & Qt::ShiftModifier, takes = event.modifiers() & Qt::ControlModifier;
    const bool shown = session().frame<2>() && session().document().dimension() == 2;
    if (shown && !isClick()) {
        if (adds && !own.isEmpty())
            change(own.united(drawn));
        else if (takes && !own.isEmpty())
            change(own.subtracted(drawn));
        else if (takes)
            emit session().notice(said(QT_TRANSLATE_NOOP("HoldTool", "Select one part to take away from.")));
        else
            hold(drawn);
    } else if (shown && !adds && !takes) {
        session().selection().clear();
    }
    m_line.clear();
    m_surface.redraw();
}

bool HoldTool::key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape) {
        if (m_active)
            cancel();
        else
            session().selection().clear();
        m_surface.redraw();
        return true;
    }
    const auto radius = brushAfter(event, m_radius, kLargestBrush);
    if (!radius || m_shape != Shape::Brush) return false;
    m_radius = *radius;
    m_surface.redraw();
    return true;
}

void HoldTool::cancel() {
    m_active = false;
    m_line.clear();
}

void HoldTool::paint(QPainter& painter) const {
    painter.setPen(QPen(QColor(kAccent), marked(1.5)));
    painter.setBrush(QColor(0x4a, 0x5b, 0xd4, 20));
    if (m_active) painter.drawPath(area());
    painter.setBrush(Qt::NoBrush);
    if (m_shape == Shape::Brush && (m_over || m_active)) painter.drawEllipse(m_at, m_radius, m_radius);
}

}  // namespace wend
