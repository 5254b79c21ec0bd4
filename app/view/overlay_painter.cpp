#include "app/view/overlay_painter.h"

#include <QCoreApplication>
#include <cmath>

namespace wend {

namespace {

constexpr double kPinRadius = 6.5;
constexpr int kMostPathsOfOneHandle = 3;
const QColor kInk(20, 22, 30);

QPixmap checker(const Theme& theme) {
    constexpr int kSquare = 10;
    QPixmap tile(2 * kSquare, 2 * kSquare);
    tile.fill(theme.checkerA);
    QPainter painter(&tile);
    painter.fillRect(0, 0, kSquare, kSquare, theme.checkerB);
    painter.fillRect(kSquare, kSquare, kSquare, kSquare, theme.checkerB);
    return tile;
}

}  // namespace

void OverlayPainter::paper(const QRectF& frame) {
    const QRectF onScreen = m_view.matrix().mapRect(frame);
    const QRect aligned = onScreen.toAlignedRect();
    m_painter.setPen(Qt::NoPen);
    for (int i = 6; i > 0; --i) {  // a soft shadow
        m_painter.setBrush(QColor(0, 0, 0, m_theme.dark ? 14 : 6));
        m_painter.drawRoundedRect(QRectF(aligned).adjusted(-i, -i + 2, i, i + 2), i, i);
    }
    m_painter.setBrushOrigin(aligned.topLeft());
    m_painter.fillRect(aligned, QBrush(checker(m_theme)));
    m_painter.setBrushOrigin(0, 0);
}

void OverlayPainter::haloLine(const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style) {
    QPen halo(QColor(255, 255, 255, 170), width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(halo);
    m_painter.drawPolyline(line);
    QPen pen(colour, width, style, Qt::FlatCap, Qt::RoundJoin);
    if (style == Qt::CustomDashLine) pen.setDashPattern({5, 3});
    m_painter.setPen(pen);
    m_painter.drawPolyline(line);
}

void OverlayPainter::path(const PinPath<2>& path, bool selected, double now) {
    QPolygonF line;
    for (const Vec<2>& p : path.points) line << m_view.toWidget(p);
    QColor colour = selected ? QColor(0x4a5bd4) : kInk;
    if (!selected) colour.setAlpha(150);
    haloLine(line, colour, selected ? 2 : 1.25, Qt::CustomDashLine);
    // Equal steps of time: filled where the shape has been already.
    m_painter.setPen(QPen(colour, 1));
    const double r = selected ? 2.8 : 2.2;
    double nextTick = std::ceil(path.times.front() * 10) / 10;
    for (int i = 0; i < line.size(); ++i) {
        if (path.times[i] < nextTick - 1e-9) continue;
        nextTick += 0.1;
        m_painter.setBrush(path.times[i] > now + 1e-9 ? QColor(Qt::white) : colour);
        m_painter.drawEllipse(line[i], r, r);
    }
}

void OverlayPainter::paths(ShapeSession& session) {
    if (session.document().isEmpty()) return;
    const auto& handles = session.document().design().handles;
    for (const bool selected : {false, true})
        for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
            if (handles[h].motions.empty() || session.selection().contains(h) != selected) continue;
            if (handles[h].activeTo <= session.playback().time()) continue;  // let go of
            auto starts = session.pathStarts(h);
            if (starts.size() > kMostPathsOfOneHandle) {  // one for all
                Vec<2> sum = Vec<2>::Zero();
                for (const Vec<2>& p : starts) sum += p;
                starts = {sum / static_cast<double>(starts.size())};
            }
            for (const PinPath<2>& one : pinPaths(handles[h], starts))
                path(one, selected, session.playback().time());
        }
}

void OverlayPainter::pin(const QPointF& at, bool selected, bool hovered, bool region) {
    const double r = kPinRadius + (hovered ? 1.5 : 0);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(0, 0, 0, 60));
    m_painter.drawEllipse(at + QPointF(0, 1), r + 2, r + 2);
    m_painter.setBrush(kInk);
    m_painter.drawEllipse(at, r + 1, r + 1);
    m_painter.setBrush(Qt::white);
    m_painter.drawEllipse(at, r, r);
    m_painter.setBrush(selected ? QColor(0x4a5bd4) : QColor(0x3a3d47));
    const double inner = selected ? r - 2.2 : r - 3.6;
    if (region)
        m_painter.drawRoundedRect(QRectF(at.x() - inner, at.y() - inner, 2 * inner, 2 * inner), 1, 1);
    else
        m_painter.drawEllipse(at, inner, inner);
}

/// A handle that is let go of, or yet to come: an empty, dashed ring.
void OverlayPainter::ghost(const QPointF& at, bool selected, bool hovered) {
    const double r = kPinRadius - 1 + (hovered ? 1.5 : 0);
    QPen halo(QColor(255, 255, 255, selected || hovered ? 230 : 150), 3);
    QPen pen(selected ? m_theme.accent : kInk, selected ? 2 : 1.25, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({2.5, 2});
    m_painter.setBrush(Qt::NoBrush);
    for (const QPen& one : {halo, pen}) {
        m_painter.setPen(one);
        m_painter.drawEllipse(at, r, r);
    }
}

void OverlayPainter::name(const QPointF& at, const QString& text) {
    const QFontMetricsF metrics(m_painter.font());
    const QRectF box(at.x() + 14, at.y() - metrics.height() / 2 - 3, metrics.horizontalAdvance(text) + 14,
                     metrics.height() + 6);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(28, 30, 38, 225));
    m_painter.drawRoundedRect(box, 5, 5);
    m_painter.setPen(Qt::white);
    m_painter.drawText(box, Qt::AlignCenter, text);
}

void OverlayPainter::spots(const PinView<2>& view, const QColor& colour) {
    m_painter.setPen(QPen(Qt::white, 1));
    m_painter.setBrush(colour);
    for (const Vec<2>& p : view.points) m_painter.drawEllipse(m_view.toWidget(p), 3.2, 3.2);
}

/// A part of the shape that is held as a whole.
void OverlayPainter::region(const PinView<2>& view, const QColor& colour) {
    QPolygonF hull;
    for (const Vec<2>& p : convexHull(view.points)) hull << m_view.toWidget(p);
    QColor fill = colour;
    fill.setAlpha(40);
    m_painter.setBrush(fill);
    m_painter.setPen(QPen(QColor(255, 255, 255, 170), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPolygon(hull);
    QPen pen(colour, 1.25, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({4, 3});
    m_painter.setPen(pen);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawPolygon(hull);
}

void OverlayPainter::pins(ShapeSession& session, int hovered) {
    const auto pins = session.pins(), ghosts = session.ghosts();
    for (const PinView<2>& view : ghosts)
        ghost(m_view.toWidget(view.centre), session.selection().contains(view.handle),
              view.handle == hovered);
    for (const PinView<2>& view : ghosts)
        if (view.handle == hovered)
            name(m_view.toWidget(view.centre),
                 QCoreApplication::translate("PinTool", "%1: does not hold now").arg(view.name));
    for (const PinView<2>& view : pins) {
        const QColor colour = session.selection().contains(view.handle) ? m_theme.accent : kInk;
        if (view.region)
            region(view, colour);
        else if (view.points.size() > 1)
            spots(view, colour);
    }
    for (const PinView<2>& view : pins)
        pin(m_view.toWidget(view.centre), session.selection().contains(view.handle), view.handle == hovered,
            view.region);
    for (const PinView<2>& view : pins)
        if (view.handle == hovered) name(m_view.toWidget(view.centre), view.name);
}

void OverlayPainter::worst(const PosedFrame<2>& frame, int cell) {
    if (cell < 0) return;
    Vec<2> centre = Vec<2>::Zero();
    for (const int v : frame.rest->cells[cell]) centre += frame.pose.col(v) / 3;
    const QPointF at = m_view.toWidget(centre);
    m_painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(Qt::white, 4.5), QPen(kInk, 2)}) {
        m_painter.setPen(pen);
        m_painter.drawEllipse(at, 11, 11);
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            m_painter.drawLine(at + 8 * way, at + 17 * way);
    }
}

void OverlayPainter::marquee(const QRectF& rectangle) {
    if (rectangle.isEmpty()) return;
    QColor fill = m_theme.accent;
    fill.setAlpha(36);
    m_painter.setPen(QPen(m_theme.accent, 1));
    m_painter.setBrush(fill);
    m_painter.drawRect(rectangle);
}

}  // namespace wend
