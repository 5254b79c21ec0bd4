#include "app/tools/area_tool.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/session/accent.h"
#include "app/session/mark_size.h"
#include "app/session/solid_places.h"
#include "app/tools/drag_label.h"
#include "app/tools/region_outline.h"

namespace wend {

namespace {

const QColor kLine(kAccent);
constexpr double kLargestBrush = 200;  // pixels
constexpr std::size_t kMostLooked = 4000;

QString said(const char* text) {
    return QCoreApplication::translate("AreaTool", text);
}

std::vector<int> sorted(std::vector<int> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace

QString AreaTool::hint() const {
    switch (m_shape) {
        case Shape::Rectangle:
            return said(QT_TRANSLATE_NOOP(
                "AreaTool",
                "Draw a rectangle over the vertices to hold; Shift adds to the selected handle, "
                "Ctrl takes away"));
        case Shape::Lasso:
            return said(QT_TRANSLATE_NOOP(
                "AreaTool",
                "Draw around the vertices to hold; Shift adds to the selected handle, Ctrl takes away"));
        case Shape::Brush:
            return said(QT_TRANSLATE_NOOP(
                "AreaTool",
                "Brush over the vertices to hold, [ and ] change the size; Shift adds, Ctrl takes "
                "away"));
        case Shape::Ball:
            return said(
                QT_TRANSLATE_NOOP("AreaTool",
                                  "Drag from a point of the surface to hold a ball; Shift adds what is in it "
                                  "to the selected handle, Ctrl takes it away"));
        case Shape::Half:
            return said(QT_TRANSLATE_NOOP(
                "AreaTool", "Drag from a point of the surface towards what to hold: all beyond the point"));
        case Shape::Box:
            break;
    }
    return said(QT_TRANSLATE_NOOP(
        "AreaTool",
        "Drag from a point of the surface to hold a box; Shift adds what is in it to the selected handle, "
        "Ctrl takes it away"));
}

void AreaTool::press(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    m_line = {m_at};
    m_brushed.clear();
    m_caught.clear();
    m_active = true;
    if (m_shape == Shape::Brush) brush();
    if (!isSolidShape()) return;
    const SolidHit hit = surface().pick(m_at);
    const auto frame = session().frame<3>();
    m_active = hit.cell >= 0 && frame;
    if (!m_active) return;
    m_centre = hit.point;
    m_restCentre =
        positionOf<3>(locationIn<3>(*frame, hit.cell, hit.point), *frame->rest, frame->rest->points);
    m_turn = cellRotation(*frame, hit.cell);
}

void AreaTool::move(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    if (m_active) m_line << m_at;
    if (m_active && m_shape == Shape::Brush) brush();
    if (m_active && (m_shape == Shape::Rectangle || m_shape == Shape::Lasso)) countCaught();
    surface().redraw();
}

/// What would be held now; nothing where looking whether so many are hidden would keep the pointer waiting.
void AreaTool::countCaught() {
    m_caught = surface().verticesWhere(insideTest(), false);
    if (m_caught.size() > kMostLooked) m_caught.clear();
    if (!m_through && !m_caught.empty()) m_caught = surface().verticesWhere(insideTest(), true);
}

void AreaTool::brush() {
    const auto near = [this](const QPointF& p) { return QLineF(p, m_at).length() <= m_radius; };
    const auto found = surface().verticesWhere(near, !m_through);
    m_brushed.insert(m_brushed.end(), found.begin(), found.end());
    m_brushed = sorted(std::move(m_brushed));
}

std::function<bool(const QPointF&)> AreaTool::insideTest() const {
    if (m_shape == Shape::Lasso)
        return [polygon = m_line](const QPointF& p) { return polygon.containsPoint(p, Qt::OddEvenFill); };
    return [box = QRectF(m_line.first(), m_at).normalized()](const QPointF& p) { return box.contains(p); };
}

std::vector<int> AreaTool::verticesInside() const {
    return m_shape == Shape::Brush ? m_brushed : surface().verticesWhere(insideTest(), !m_through);
}

/// Around the place in the rest shape, as large as it was drawn in the pose.
Region<3> AreaTool::region() const {
    const Vec<3> way = m_turn.transpose() * (acrossTheScreen(surface(), m_centre, m_at) -
                                             acrossTheScreen(surface(), m_centre, m_line.first()));
    const double radius = way.norm();
    if (m_shape == Shape::Ball) return Ball<3>{m_restCentre, radius};
    if (m_shape == Shape::Half) return HalfSpace<3>{m_restCentre, way.normalized()};
    return Box<3>{m_restCentre.array() - radius, m_restCentre.array() + radius};
}

/// The whole line stayed where it began: a lasso comes back there. A region is as large as the way to the
/// pointer is now.
bool AreaTool::isClick() const {
    const auto stays = [this](const QPointF& p) { return QLineF(m_line.first(), p).length() < 4; };
    return !m_line.isEmpty() && stays(m_at) &&
           (isSolidShape() || std::all_of(m_line.begin(), m_line.end(), stays));
}

/// Adding to nothing makes a new handle; there is nothing to take away from it.
void AreaTool::tellNothingToTakeFrom() const {
    emit session().notice(said(QT_TRANSLATE_NOOP("AreaTool", "Select one handle to take away from.")));
}

void AreaTool::release(const QMouseEvent& event) {
    m_at = event.position();
    m_over = true;
    if (std::exchange(m_active, false) && session().frame<3>()) finish(event.modifiers());
    m_line.clear();
    m_brushed.clear();
    m_caught.clear();
    surface().redraw();
}

void AreaTool::finishRegion(bool changes) {
    if (isClick()) return;
    const auto vertices = verticesIn(region(), *session().frame<3>()->rest);
    const bool one = session().selection().handles().size() == 1;
    if (vertices.empty())
        emit session().notice(said(QT_TRANSLATE_NOOP("AreaTool", "There is no vertex in this region.")));
    else if (changes && one)
        changeSelected(vertices, m_adds);
    else if (changes && !m_adds)
        tellNothingToTakeFrom();
    else
        session().addHandle<3>(region(), said(QT_TRANSLATE_NOOP("AreaTool", "Region")).toStdString());
}

void AreaTool::finish(Qt::KeyboardModifiers modifiers) {
    m_adds = modifiers & Qt::ShiftModifier;
    const bool changes = m_adds || modifiers & Qt::ControlModifier;
    if (isSolidShape()) {
        finishRegion(changes);
        return;
    }
    std::vector<int> vertices = verticesInside();
    const SolidHit hit = changes && isClick() ? surface().pick(m_at) : SolidHit{};
    if (hit.vertex >= 0 && m_shape != Shape::Brush) vertices = {hit.vertex};
    const bool one = session().selection().handles().size() == 1;
    if (changes && one)
        changeSelected(vertices, m_adds);
    else if (changes && !m_adds)
        tellNothingToTakeFrom();
    else if (!vertices.empty())
        session().addSolidHandle(vertices, said(QT_TRANSLATE_NOOP("AreaTool", "Area")).toStdString());
    else
        session().selection().clear();
}

void AreaTool::changeSelected(std::vector<int> vertices, bool add) {
    const int handle = session().selection().handles().front();
    std::vector<int> own = session().verticesOf(handle);
    std::vector<int> result;
    vertices = sorted(std::move(vertices));
    if (add)
        std::set_union(own.begin(), own.end(), vertices.begin(), vertices.end(), std::back_inserter(result));
    else
        std::set_difference(own.begin(), own.end(), vertices.begin(), vertices.end(),
                            std::back_inserter(result));
    if (result.empty())
        emit session().notice(
            said(QT_TRANSLATE_NOOP("AreaTool", "A handle cannot hold nothing: remove it with Delete.")));
    else if (result != own)
        session().changeHandle(handle, result);
}

bool AreaTool::key(const QKeyEvent& event) {
    if (event.key() == Qt::Key_Escape) {
        if (m_active)
            cancel();
        else
            session().selection().clear();
        surface().redraw();
        return true;
    }
    const auto radius = brushAfter(event, m_radius, kLargestBrush);
    if (!radius || m_shape != Shape::Brush) return false;
    m_radius = *radius;
    surface().redraw();
    return true;
}

void AreaTool::cancel() {
    m_active = false;
    m_line.clear();
    m_brushed.clear();
    m_caught.clear();
}

void AreaTool::paint(QPainter& painter) const {
    QColor fill = kLine;
    fill.setAlpha(40);
    painter.setPen(QPen(kLine, marked(1.25)));
    painter.setBrush(fill);
    if (m_shape == Shape::Brush) {
        if (m_over || m_active) painter.drawEllipse(m_at, m_radius, m_radius);
        painter.setBrush(kLine);
        painter.setPen(QPen(Qt::white, marked(0.75)));
        if (const auto frame = session().frame<3>(); frame && m_active)
            for (const int v : m_brushed)
                painter.drawEllipse(surface().toWidget(frame->pose.col(v)), marked(2.6), marked(2.6));
    }
    if (!m_active) return;
    if (m_shape == Shape::Lasso) painter.drawPolygon(m_line);
    if (m_shape == Shape::Rectangle) painter.drawRect(QRectF(m_line.first(), m_at).normalized());
    if (isSolidShape() && !isClick()) paintRegion(painter);
    if (!m_caught.empty() && session().frame<3>()) paintCaught(painter, m_caught);
}

/// The region where the solid now is, with the number of vertices in it.
void AreaTool::paintRegion(QPainter& painter) const {
    const auto frame = session().frame<3>();
    if (!frame) return;
    const Region<3> drawn = region();
    const auto& rest = frame->rest->points;
    painter.setBrush(Qt::NoBrush);
    for (const auto& line : regionOutline(drawn, rest.rowwise().minCoeff(), rest.rowwise().maxCoeff())) {
        QPolygonF screen;
        for (const Vec<3>& p : line) screen << surface().toWidget(m_centre + m_turn * (p - m_restCentre));
        painter.drawPolyline(screen);
    }
    paintCaught(painter, verticesIn(drawn, *frame->rest));
}

/// The vertices, and how many they are.
void AreaTool::paintCaught(QPainter& painter, const std::vector<int>& held) const {
    const auto frame = session().frame<3>();
    painter.setBrush(kLine);
    painter.setPen(QPen(Qt::white, marked(0.75)));
    for (const int v : held)
        painter.drawEllipse(surface().toWidget(frame->pose.col(v)), marked(2.6), marked(2.6));
    const QString text =
        QCoreApplication::translate("AreaTool", "%n vertices", nullptr, static_cast<int>(held.size()));
    paintLabel(painter, m_at + QPointF(16, 12), text);
}

}  // namespace wend
