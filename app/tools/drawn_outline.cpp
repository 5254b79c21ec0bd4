#include "app/tools/drawn_outline.h"

#include <algorithm>

#include "app/session/accent.h"
#include "app/session/mark_size.h"
#include "app/tools/tool.h"

namespace wend {

namespace {

constexpr double kLargestBrush = 200;  // pixels

}  // namespace

void DrawnOutline::begin(const QPointF& at) {
    m_line = {at};
    m_end = at;
}

void DrawnOutline::goOn(const QPointF& at) {
    m_line << at;
    m_end = at;
}

bool DrawnOutline::contains(const QPointF& p) const {
    switch (m_kind) {
        case Kind::Lasso:
            return m_line.containsPoint(p, Qt::OddEvenFill);
        case Kind::Brush:
            return std::any_of(m_line.begin(), m_line.end(),
                               [&](const QPointF& at) { return QLineF(at, p).length() <= m_radius; });
        case Kind::Rectangle:
            break;
    }
    return QRectF(m_line.first(), m_end).normalized().contains(p);
}

bool DrawnOutline::key(const QKeyEvent& event) {
    const auto radius = brushAfter(event, m_radius, kLargestBrush);
    if (!radius || m_kind != Kind::Brush) return false;
    m_radius = *radius;
    return true;
}

void DrawnOutline::paint(QPainter& painter) const {
    const QColor line(kAccent), fill(line.red(), line.green(), line.blue(), 40);
    painter.setPen(QPen(line, marked(1)));
    painter.setBrush(fill);
    if (m_kind == Kind::Rectangle) painter.drawRect(QRectF(m_line.first(), m_end).normalized());
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
