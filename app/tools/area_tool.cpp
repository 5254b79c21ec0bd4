#include "app/tools/area_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace wend {

namespace {

const QColor kLine(0x4a5bd4);

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
            return said(QT_TRANSLATE_NOOP("AreaTool", "Drag from a point of the surface to hold a ball"));
        case Shape::Box:
            break;
    }
    return said(QT_TRANSLATE_NOOP("AreaTool", "Drag from a point of the surface to hold a box"));
}

void AreaTool::press(const QMouseEvent& event) {
    m_at = event.position();
    m_line = {m_at};
    m_brushed.clear();
    m_active = true;
    if (m_shape == Shape::Brush) brush();
    if (!isSolidShape()) return;
    const SolidHit hit = surface().pick(m_at);
    m_active = hit.vertex >= 0;
    m_vertex = hit.vertex;
    m_centre = hit.point;
}

void AreaTool::move(const QMouseEvent& event) {
    m_at = event.position();
    if (m_active) m_line << m_at;
    if (m_active && m_shape == Shape::Brush) brush();
    surface().redraw();
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

/// Around the vertex in the rest shape, as large as it was drawn in the pose.
Region<3> AreaTool::region() const {
    const auto frame = session().frame<3>();
    const Vec<3> centre = frame->rest->points.col(m_vertex);
    const double radius = QLineF(m_line.first(), m_at).length() * surface().pixelSize(m_centre);
    if (m_shape == Shape::Ball) return Ball<3>{centre, radius};
    return Box<3>{centre.array() - radius, centre.array() + radius};
}

void AreaTool::release(const QMouseEvent& event) {
    m_at = event.position();
    if (std::exchange(m_active, false) && session().frame<3>()) finish(event.modifiers());
    m_line.clear();
    m_brushed.clear();
    surface().redraw();
}

void AreaTool::finish(Qt::KeyboardModifiers modifiers) {
    if (isSolidShape()) {
        if (QLineF(m_line.first(), m_at).length() >= 4)
            session().addHandle<3>(region(), said(QT_TRANSLATE_NOOP("AreaTool", "Region")).toStdString());
        return;
    }
    const std::vector<int> vertices = verticesInside();
    const bool add = modifiers & Qt::ShiftModifier, remove = modifiers & Qt::ControlModifier;
    const bool one = session().selection().handles().size() == 1;
    if ((add || remove) && one)
        changeSelected(vertices, add);
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
    if (!result.empty() && result != own) session().changeHandle(handle, result);
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
    const double factor = event.text() == "[" ? 0.8 : event.text() == "]" ? 1.25 : 1;
    if (factor == 1 || m_shape != Shape::Brush) return false;
    m_radius = std::clamp(m_radius * factor, 4.0, 200.0);
    surface().redraw();
    return true;
}

void AreaTool::cancel() {
    m_active = false;
    m_line.clear();
    m_brushed.clear();
}

void AreaTool::paint(QPainter& painter) const {
    QColor fill = kLine;
    fill.setAlpha(40);
    painter.setPen(QPen(kLine, 1.25));
    painter.setBrush(fill);
    if (m_shape == Shape::Brush) {
        painter.drawEllipse(m_at, m_radius, m_radius);
        painter.setBrush(kLine);
        painter.setPen(QPen(Qt::white, 0.75));
        if (const auto frame = session().frame<3>(); frame && m_active)
            for (const int v : m_brushed)
                painter.drawEllipse(surface().toWidget(frame->pose.col(v)), 2.6, 2.6);
    }
    if (!m_active) return;
    if (m_shape == Shape::Lasso) painter.drawPolygon(m_line);
    if (m_shape == Shape::Rectangle) painter.drawRect(QRectF(m_line.first(), m_at).normalized());
    if (!isSolidShape()) return;
    const double radius = QLineF(m_line.first(), m_at).length();
    if (m_shape == Shape::Ball) {
        painter.drawEllipse(m_line.first(), radius, radius);
        return;
    }
    const double half = radius * surface().pixelSize(m_centre);
    painter.setBrush(Qt::NoBrush);
    const auto corner = [&](int i) {
        const Vec<3> side(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half);
        return surface().toWidget(m_centre + side);
    };
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit)) painter.drawLine(corner(i), corner(i | bit));
}

}  // namespace wend
