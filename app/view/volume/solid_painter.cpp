#include "app/view/volume/solid_painter.h"

#include <algorithm>
#include <cmath>

#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr double kPinRadius = 6.5;
constexpr int kMostPathsOfOneHandle = 3;
constexpr int kFramesAlongCurve = 9;
const QColor kInk(20, 22, 30);
const QColor kAxes[] = {QColor(214, 69, 65), QColor(72, 148, 60), QColor(58, 104, 214)};

}  // namespace

void SolidPainter::haloLine(const QPolygonF& line, const QColor& colour, double width, Qt::PenStyle style) {
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(QColor(255, 255, 255, 170), width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPolyline(line);
    QPen pen(colour, width, style, Qt::FlatCap, Qt::RoundJoin);
    if (style == Qt::CustomDashLine) pen.setDashPattern({5, 3});
    m_painter.setPen(pen);
    m_painter.drawPolyline(line);
}

void SolidPainter::path(const PinPath<3>& path, bool selected, double now) {
    QPolygonF line;
    for (const Vec<3>& p : path.points) line << m_surface.toWidget(p);
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

/// The local frames that a curve carries along.
void SolidPainter::frames(const Handle<3>& handle, const Vec<3>& start) {
    for (const Motion<3>& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
        if (!curve || curve->frame == FrameKind::None) continue;
        const Trajectory<3> trajectory(motion);
        for (int i = 0; i < kFramesAlongCurve; ++i) {
            const double t = motion.start + (motion.end - motion.start) * i / (kFramesAlongCurve - 1);
            const Vec<3> at = trajectory.at(t).position(start);
            const Mat<3> F = trajectory.frame(t);
            for (int k = 0; k < 3; ++k)
                haloLine({m_surface.toWidget(at),
                          m_surface.toWidget(at + 26 * m_surface.pixelSize(at) * F.col(k))},
                         kAxes[k], 1.75, Qt::SolidLine);
        }
    }
}

void SolidPainter::paths() {
    ShapeSession& session = m_surface.session();
    if (session.document().dimension() != 3) return;
    const auto& handles = session.document().design<3>().handles;
    for (const bool selected : {false, true})
        for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
            if (handles[h].motions.empty() || session.selection().contains(h) != selected) continue;
            if (handles[h].activeTo <= session.playback().time()) continue;  // let go of
            auto starts = session.pathStarts<3>(h);
            if (starts.empty()) continue;
            if (starts.size() > kMostPathsOfOneHandle) starts = {meanOf<3>(starts)};  // one for all
            for (const PinPath<3>& one : pinPaths<3>(handles[h], starts))
                path(one, selected, session.playback().time());
            if (selected) frames(handles[h], starts.front());
        }
}

void SolidPainter::pin(const QPointF& at, bool selected, bool hovered, bool area, bool hidden) {
    const double r = kPinRadius + (hovered ? 1.5 : 0);
    m_painter.setOpacity(hidden ? 0.4 : 1);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(0, 0, 0, 60));
    m_painter.drawEllipse(at + QPointF(0, 1), r + 2, r + 2);
    m_painter.setBrush(kInk);
    m_painter.drawEllipse(at, r + 1, r + 1);
    m_painter.setBrush(Qt::white);
    m_painter.drawEllipse(at, r, r);
    m_painter.setBrush(selected ? QColor(0x4a5bd4) : QColor(0x3a3d47));
    const double inner = selected ? r - 2.2 : r - 3.6;
    if (area)
        m_painter.drawRoundedRect(QRectF(at.x() - inner, at.y() - inner, 2 * inner, 2 * inner), 1, 1);
    else
        m_painter.drawEllipse(at, inner, inner);
    m_painter.setOpacity(1);
}

void SolidPainter::name(const QPointF& at, const QString& text) {
    const QFontMetricsF metrics(m_painter.font());
    const QRectF box(at.x() + 14, at.y() - metrics.height() / 2 - 3, metrics.horizontalAdvance(text) + 14,
                     metrics.height() + 6);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(QColor(28, 30, 38, 225));
    m_painter.drawRoundedRect(box, 5, 5);
    m_painter.setPen(Qt::white);
    m_painter.drawText(box, Qt::AlignCenter, text);
}

/// What a handle of many vertices holds.
void SolidPainter::spots(const PinView<3>& view, const QColor& colour) {
    const bool selected = m_surface.session().selection().contains(view.handle);
    QColor fill = colour;
    fill.setAlpha(selected ? 255 : 110);
    m_painter.setPen(selected ? QPen(QColor(255, 255, 255, 190), 0.75) : QPen(Qt::NoPen));
    m_painter.setBrush(fill);
    const double r = selected ? 2.3 : 1.7;
    for (const Vec<3>& p : view.points) m_painter.drawEllipse(m_surface.toWidget(p), r, r);
}

void SolidPainter::pins(int hovered) {
    ShapeSession& session = m_surface.session();
    const auto pins = session.pins<3>();
    for (const PinView<3>& view : pins)
        if (view.points.size() > 1)
            spots(view, session.selection().contains(view.handle) ? m_theme.accent : kInk);
    for (const PinView<3>& view : pins) {
        const bool area = view.points.size() > 1;
        pin(m_surface.toWidget(view.centre), session.selection().contains(view.handle),
            view.handle == hovered, area, !area && m_surface.isHidden(view.centre));
    }
    for (const PinView<3>& view : pins)
        if (view.handle == hovered) name(m_surface.toWidget(view.centre), view.name);
}

void SolidPainter::worst(const PosedFrame<3>& frame, int cell) {
    if (cell < 0) return;
    Vec<3> centre = Vec<3>::Zero();
    for (const int v : frame.rest->cells[cell]) centre += frame.pose.col(v) / 4;
    const QPointF at = m_surface.toWidget(centre);
    m_painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(Qt::white, 4.5), QPen(kInk, 2)}) {
        m_painter.setPen(pen);
        m_painter.drawEllipse(at, 11, 11);
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            m_painter.drawLine(at + 8 * way, at + 17 * way);
    }
}

void SolidPainter::compass(const QPointF& at, const Mat<3>& worldToScreen) {
    std::array<int, 3> order = {0, 1, 2};  // the nearest last
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return worldToScreen(2, a) < worldToScreen(2, b); });
    static const QString kNames[] = {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};
    QFont font = m_painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    font.setBold(true);
    m_painter.setFont(font);
    for (const int k : order) {
        const QPointF tip = at + 30 * QPointF(worldToScreen(0, k), -worldToScreen(1, k));
        m_painter.setPen(QPen(kAxes[k], 2.25, Qt::SolidLine, Qt::RoundCap));
        m_painter.drawLine(at, tip);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(kAxes[k]);
        m_painter.drawEllipse(tip, 8, 8);
        m_painter.setPen(Qt::white);
        m_painter.drawText(QRectF(tip.x() - 8, tip.y() - 8, 16, 16), Qt::AlignCenter, kNames[k]);
    }
}

}  // namespace wend
