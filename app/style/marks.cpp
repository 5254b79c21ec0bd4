#include "app/style/marks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/style/colours.h"

namespace wend {

namespace {

double chosen = 1;

}  // namespace

double markSize() {
    return chosen;
}

void setMarkSize(double factor) {
    chosen = factor;
}

const std::array<QColor, 8>& pinColours() {
    static const std::array<QColor, 8> kColours = {QColor(0x2e77ae), QColor(0xd9822b), QColor(0x0b7a5b),
                                                   QColor(0xb3261e), QColor(0x7a4fb5), QColor(0x8a5a00),
                                                   QColor(0x12a594), QColor(0x54267f)};
    return kColours;
}

QColor pinColour(int handle, const PinTraits& traits) {
    if (traits.colour) return QColor::fromRgb(*traits.colour);
    return pinColours()[static_cast<std::size_t>(std::max(handle, 0)) % pinColours().size()];
}

/// Draws a light line with a dark rim, visible on any background.
void Marks::halo(const QPolygonF& line, double width) {
    m_painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(QColor(kInk.red(), kInk.green(), kInk.blue(), 89), width + marked(3)),
                            QPen(QColor(255, 255, 255, 217), width + marked(2))}) {
        QPen round = pen;
        round.setCapStyle(Qt::RoundCap);
        round.setJoinStyle(Qt::RoundJoin);
        m_painter.setPen(round);
        m_painter.drawPolyline(line);
    }
}

void Marks::hairline(const QPolygonF& line, const QColor& colour) {
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    m_painter.setPen(QPen(colour, 0));
    m_painter.drawPolyline(line);
    m_painter.setRenderHint(QPainter::Antialiasing);
}

void Marks::line(const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style) {
    if (m_quick) return hairline(line, colour);
    width = marked(width);
    halo(line, width);
    QPen pen(colour, width, style, Qt::FlatCap, Qt::RoundJoin);
    if (style == Qt::CustomDashLine) pen.setDashPattern({4, 3});
    m_painter.setPen(pen);
    m_painter.drawPolyline(line);
}

void Marks::path(const QPolygonF& line, const std::vector<double>& times, bool selected, double now,
                 bool hovered) {
    QColor colour = selected ? QColor(kAccent) : kInk;
    if (!selected) colour.setAlpha(153);
    const double width = marked(selected || hovered ? 2 : 1.25);
    if (m_quick) return hairline(line, colour);
    QPolygonF gone, coming;
    for (int i = 0; i < line.size(); ++i) {
        if (times[i] <= now + 1e-9) gone << line[i];
        if (times[i] > now + 1e-9 || i + 1 == line.size() || times[i + 1] > now + 1e-9) coming << line[i];
    }
    halo(line, width);
    QPen pen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    m_painter.setPen(pen);
    m_painter.drawPolyline(gone);
    pen.setDashPattern({5, 4});
    m_painter.setPen(pen);
    m_painter.drawPolyline(coming);
    m_painter.setPen(QPen(QColor(255, 255, 255, 217), marked(1)));
    m_painter.setBrush(colour);
    double next = std::ceil(times.front() * 10 - 1e-6);
    for (int i = 0; i < line.size(); ++i) {
        if (times[i] * 10 < next - 1e-6) continue;
        const bool second = std::abs(std::remainder(next, 10.0)) < 0.5;
        const double r = marked((selected ? 2.4 : 1.8) + (second ? 1.4 : 0));
        m_painter.drawEllipse(line[i], r, r);
        next = std::floor(times[i] * 10 + 1e-6) + 1;
    }
}

/// Draws around a place in the chosen size of marks.
void Marks::enlarged(const QPointF& at, const std::function<void()>& draw) {
    m_painter.save();
    m_painter.translate(at);
    m_painter.scale(marked(1), marked(1));
    draw();
    m_painter.restore();
}

void Marks::pin(const QPointF& at, const Pin& look) {
    if (markSize() == 1) return drawPin(at, look);
    enlarged(at, [&] { drawPin({}, look); });
}

void Marks::drawPin(const QPointF& at, const Pin& look) {
    const double r = look.hovered ? 8 : kPinRadius;
    const QColor accent(kAccent);
    const auto disc = [&](double radius) {
        if (look.region)
            m_painter.drawRoundedRect(QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius), 3, 3);
        else
            m_painter.drawEllipse(at, radius, radius);
    };
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(0, 0, 0, 60));
    m_painter.drawEllipse(at + QPointF(0, 1), r + 2, r + 2);
    if (look.selected) {
        m_painter.setBrush(Qt::white);
        disc(r + 5);
        m_painter.setBrush(accent);
        disc(r + 4);
        m_painter.setBrush(Qt::white);
        disc(r + 2);
    }
    m_painter.setBrush(kInk);
    disc(r + 1);
    m_painter.setBrush(look.moves ? QColor(Qt::white) : kInk);
    disc(r);
    if (!look.moves) {
        m_painter.setPen(QPen(Qt::white, 1));
        m_painter.setBrush(Qt::NoBrush);
        disc(r);
        m_painter.setPen(Qt::NoPen);
    }
    m_painter.setBrush(!look.moves ? QColor(Qt::white) : look.selected ? accent : look.colour);
    m_painter.drawEllipse(at, 3, 3);
    if (look.locked) padlock(at + QPointF(r + 2, -r - 2));
}

void Marks::padlock(const QPointF& at) {
    const QRectF body(at.x() - 4, at.y() - 1, 8, 6), shackle(at.x() - 2.5, at.y() - 5, 5, 7);
    for (const auto& [colour, width] : {std::pair{QColor(Qt::white), 4.0}, {kInk, 1.5}}) {
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(colour, width));
        m_painter.drawArc(shackle, 0, 180 * 16);
        m_painter.setBrush(colour);
        m_painter.drawRoundedRect(body, 1, 1);
    }
    m_painter.setPen(Qt::NoPen);
}

void Marks::ghost(const QPointF& place, bool selected, bool hovered) {
    if (markSize() != 1)
        enlarged(place, [&] { drawGhost({}, selected, hovered); });
    else
        drawGhost(place, selected, hovered);
}

void Marks::drawGhost(const QPointF& at, bool selected, bool hovered) {
    const double r = kPinRadius - 1 + (hovered ? 1.5 : 0);
    QPen halo(QColor(255, 255, 255, selected || hovered ? 230 : 150), 3);
    QPen pen(selected ? QColor(kAccent) : kInk, selected ? 2 : 1.25, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({2.5, 2});
    m_painter.setBrush(Qt::NoBrush);
    for (const QPen& one : {halo, pen}) {
        m_painter.setPen(one);
        m_painter.drawEllipse(at, r, r);
    }
}

void Marks::name(const QPointF& at, const QString& text) {
    markSize() == 1 ? drawName(at, text) : enlarged(at, [&] { drawName({}, text); });
}

void Marks::drawName(const QPointF& at, const QString& text) {
    const QFontMetricsF metrics(m_painter.font());
    const QRectF box(at.x() + 20, at.y() - metrics.height() / 2 - 3, metrics.horizontalAdvance(text) + 14,
                     metrics.height() + 6);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(28, 30, 38, 225));
    m_painter.drawRoundedRect(box, 5, 5);
    m_painter.setPen(Qt::white);
    m_painter.drawText(box, Qt::AlignCenter, text);
}

void Marks::spots(const std::vector<QPointF>& places, const QColor& fill, double radius, QPen rim) {
    if (places.empty()) return;
    radius = marked(radius);
    rim.setWidthF(marked(rim.widthF()));
    const double ratio = m_painter.device()->devicePixelRatioF(),
                 half = std::ceil(radius + rim.widthF() / 2 + 1);
    QPixmap stamp((QSizeF(2 * half, 2 * half) * ratio).toSize());
    stamp.setDevicePixelRatio(ratio);
    stamp.fill(Qt::transparent);
    QPainter painter(&stamp);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(rim);
    painter.setBrush(fill);
    painter.drawEllipse(QPointF(half, half), radius, radius);
    painter.end();
    for (const QPointF& at : places) m_painter.drawPixmap(at - QPointF(half, half), stamp);
}

void Marks::worst(const QPointF& at, bool hidden) {
    markSize() == 1 ? drawWorst(at, hidden) : enlarged(at, [&] { drawWorst({}, hidden); });
}

void Marks::drawWorst(const QPointF& at, bool hidden) {
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
