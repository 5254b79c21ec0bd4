#include "app/tools/drawn_outline.h"

#include <QPainterPathStroker>
#include <algorithm>

#include "app/style/colours.h"
#include "app/style/marks.h"
#include "app/tools/pin_settings.h"
#include "app/tools/tool.h"

namespace wend {

namespace {

constexpr double kClickLength = 4;  // pixels

}  // namespace

double distanceToLine(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF along = b - a;
    const double size = QPointF::dotProduct(along, along);
    const double t = size > 0 ? QPointF::dotProduct(p - a, along) / size : 0;
    return QLineF(p, a + std::clamp(t, 0.0, 1.0) * along).length();
}

QPainterPath insideOf(const QPolygonF& line) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    path.addPolygon(line);
    path.closeSubpath();
    return path;
}

QPainterPath brushedAlong(const QPolygonF& line, double radius) {
    QPainterPath path, way;
    path.setFillRule(Qt::WindingFill);
    way.addPolygon(line);
    QPainterPathStroker stroker;
    stroker.setWidth(2 * radius);
    stroker.setCapStyle(Qt::RoundCap);
    stroker.setJoinStyle(Qt::RoundJoin);
    if (way.length() > 0)
        path.addPath(stroker.createStroke(way));
    else
        path.addEllipse(line.first(), radius, radius);
    return path;
}

void DrawnOutline::begin(const QPointF& at) {
    m_line = {at, at};
    m_end = at;
}

void DrawnOutline::goOn(const QPointF& at) {
    m_line << at;
    m_end = at;
}

QPainterPath DrawnOutline::area() const {
    if (m_kind == Kind::Lasso) return insideOf(m_line);
    if (m_kind == Kind::Brush) return brushedAlong(m_line, m_radius);
    QPainterPath path;
    path.addRect(box());
    return path;
}

bool DrawnOutline::contains(const QPointF& p) const {
    if (m_kind == Kind::Lasso) return m_line.containsPoint(p, Qt::WindingFill);
    if (m_kind == Kind::Rectangle) return box().contains(p);
    return std::adjacent_find(m_line.begin(), m_line.end(), [&](const QPointF& a, const QPointF& b) {
               return distanceToLine(p, a, b) <= m_radius;
           }) != m_line.end();
}

bool DrawnOutline::isNewlyBrushed(const QPointF& p) const {
    return distanceToLine(p, m_line[m_line.size() - 2], m_line.last()) <= m_radius;
}

bool DrawnOutline::isClick() const {
    const auto stays = [this](const QPointF& p) { return QLineF(m_line.first(), p).length() < kClickLength; };
    return m_kind != Kind::Brush && stays(m_end) && std::all_of(m_line.begin(), m_line.end(), stays);
}

std::optional<double> DrawnOutline::radiusAfter(const QKeyEvent& event) const {
    return m_kind == Kind::Brush ? brushAfter(event, m_radius, PinSettings::kLargest) : std::nullopt;
}

void DrawnOutline::paint(QPainter& painter) const {
    const QColor line(kAccent), fill(line.red(), line.green(), line.blue(), 40);
    painter.setPen(QPen(line, marked(1)));
    painter.setBrush(fill);
    if (m_kind == Kind::Rectangle) painter.drawRect(box());
    if (m_kind == Kind::Lasso) painter.drawPolygon(m_line);
    if (m_kind != Kind::Brush) return;
    painter.setPen(QPen(fill, 2 * m_radius, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(m_line);
    paintBrush(painter, m_end);
}

void DrawnOutline::paintBrush(QPainter& painter, const QPointF& at) const {
    painter.setPen(QPen(QColor(kAccent), marked(1)));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, m_radius, m_radius);
}

}  // namespace wend
