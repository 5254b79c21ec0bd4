#include "app/panels/marks.h"

#include <cmath>

#include "app/session/accent.h"

namespace wend {

void Marks::line(const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style) {
    QPen halo(QColor(255, 255, 255, 170), width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(halo);
    m_painter.drawPolyline(line);
    QPen pen(colour, width, style, Qt::FlatCap, Qt::RoundJoin);
    if (style == Qt::CustomDashLine) pen.setDashPattern({5, 3});
    m_painter.setPen(pen);
    m_painter.drawPolyline(line);
}

void Marks::path(const QPolygonF& line, const std::vector<double>& times, bool selected, double now) {
    QColor colour = selected ? QColor(kAccent) : kInk;
    if (!selected) colour.setAlpha(150);
    this->line(line, colour, selected ? 2 : 1.25, Qt::CustomDashLine);
    m_painter.setPen(QPen(colour, 1));
    const double r = selected ? 2.8 : 2.2;
    double nextTick = std::ceil(times.front() * 10) / 10;
    for (int i = 0; i < line.size(); ++i) {
        if (times[i] < nextTick - 1e-9) continue;
        nextTick += 0.1;
        m_painter.setBrush(times[i] > now + 1e-9 ? QColor(Qt::white) : colour);
        m_painter.drawEllipse(line[i], r, r);
    }
}

void Marks::pin(const QPointF& at, bool selected, bool hovered, bool square) {
    const double r = kPinRadius + (hovered ? 1.5 : 0);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(0, 0, 0, 60));
    m_painter.drawEllipse(at + QPointF(0, 1), r + 2, r + 2);
    m_painter.setBrush(kInk);
    m_painter.drawEllipse(at, r + 1, r + 1);
    m_painter.setBrush(Qt::white);
    m_painter.drawEllipse(at, r, r);
    m_painter.setBrush(selected ? QColor(kAccent) : QColor(0x3a3d47));
    const double inner = selected ? r - 2.2 : r - 3.6;
    if (square)
        m_painter.drawRoundedRect(QRectF(at.x() - inner, at.y() - inner, 2 * inner, 2 * inner), 1, 1);
    else
        m_painter.drawEllipse(at, inner, inner);
}

void Marks::name(const QPointF& at, const QString& text) {
    const QFontMetricsF metrics(m_painter.font());
    const QRectF box(at.x() + 14, at.y() - metrics.height() / 2 - 3, metrics.horizontalAdvance(text) + 14,
                     metrics.height() + 6);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(28, 30, 38, 225));
    m_painter.drawRoundedRect(box, 5, 5);
    m_painter.setPen(Qt::white);
    m_painter.drawText(box, Qt::AlignCenter, text);
}

void Marks::worst(const QPointF& at, bool hidden) {
    m_painter.setBrush(Qt::NoBrush);
    QPen ink(kInk, 2);
    if (hidden) ink.setDashPattern({2, 2});
    if (hidden) m_painter.setOpacity(0.4);
    for (const QPen& pen : {QPen(Qt::white, 4.5), ink}) {
        m_painter.setPen(pen);
        m_painter.drawEllipse(at, 11, 11);
        if (hidden) continue;
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            m_painter.drawLine(at + 8 * way, at + 17 * way);
    }
    m_painter.setOpacity(1);
}

}  // namespace wend
