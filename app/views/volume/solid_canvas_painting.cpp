// Overlays of a solid.
#include "app/views/shape/shape_painter.h"
#include "app/views/volume/solid_canvas.h"

namespace wend {

namespace {

/// Paints a small cross of the axes of the world, the nearest last.
void paintCompass(QPainter& painter, const QPointF& at, const Mat<3>& worldToScreen) {
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return worldToScreen(2, a) < worldToScreen(2, b); });
    static const QString kNames[] = {QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    font.setBold(true);
    painter.setFont(font);
    for (const int k : order) {
        const QPointF tip = at + 30 * QPointF(worldToScreen(0, k), -worldToScreen(1, k));
        painter.setPen(QPen(kSpaceAxes[k], 2.25, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at, tip);
        painter.setPen(Qt::NoPen);
        painter.setBrush(kSpaceAxes[k]);
        painter.drawEllipse(tip, 8, 8);
        painter.setPen(Qt::white);
        painter.drawText(QRectF(tip.x() - 8, tip.y() - 8, 16, 16), Qt::AlignCenter, kNames[k]);
    }
}

}  // namespace

void SolidCanvas::paintOver(QPainter& painter) {
    m_viewport.marksPainted();
    paintMarks(painter);
    if (m_viewport.looks().hidden || !m_session.frame<3>()) return;
    m_layer.setLayer(m_viewport.looks().layer);
    m_layer.paint(painter, *this);
    m_detailRegions.paint(painter, *this);
    if (!m_session.playback().isPlaying()) {
        m_cutTool.paint(painter);
        if (const Tool* tool = m_viewport.tool()) tool->paint(painter);
    }
    m_viewport.paintLegend(painter, size());
}

void SolidCanvas::paintMarks(QPainter& painter) {
    const auto frame = m_session.frame<3>();
    const Looks& looks = m_viewport.looks();
    const Measure measure = looks.colours.measure;
    if (shown().pose.cols() == 0) return;
    painter.save();
    paintCompass(painter, QPointF(46, height() - 46), camera().view().topLeftCorner<3, 3>());
    painter.restore();
    if (looks.hidden || !frame) return;
    const Theme theme = Theme::of(palette());
    ShapePainter over(painter, *this, theme);
    if (looks.map && isDistortion(measure)) over.worst(*frame, measure);
    if (m_pointedOf == frame->shape) over.worst(*frame, m_pointedCell);
    m_onion.setShown(looks.onionSkin);
    m_onion.paintOutlines(painter, *this);
    if (const auto& built = *frame->built; built.cloud && looks.detail)
        over.dots(built.cloudEmbedding->carry(*frame->rest, frame->pose));
    if (m_session.playback().isPlaying()) return;  // pins are hidden during playback
    if (looks.groups) over.groups(*looks.groups);
    over.paths(m_viewport.hovered());
    over.pins(m_viewport.hovered(), m_viewport.named());
}

}  // namespace wend
