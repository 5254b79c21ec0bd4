#include "app/views/volume/solid_overlay.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/engine/motion/places.h"
#include "app/engine/shape/shape.h"
#include "app/session/shape_session.h"
#include "app/views/shape/shape_painter.h"

namespace wend {

namespace {

/// Paints a small cross of the axes of the world, the nearest last.
void paintCompass(QPainter& painter, const QPointF& at, const Mat3& worldToScreen) {
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

SolidOverlay::SolidOverlay(SolidCanvas& canvas) : QWidget(&canvas), m_canvas(canvas) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
}

void SolidOverlay::markCell(int cell, const std::shared_ptr<const void>& mesh) {
    m_marked = cell;
    m_markedOf = mesh;
}

void SolidOverlay::setDetailRegions(const std::vector<SoftRegion>& regions) {
    m_detailRegions.setRegions(regions);
    update();
}

void SolidOverlay::paintEvent(QPaintEvent*) {
    Viewport& viewport = m_canvas.viewport();
    viewport.marksPainted();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarks(painter);
    if (viewport.looks().hidden || !m_canvas.session().motion().frame<3>()) return;
    m_layer.setLayer(viewport.looks().layer);
    m_layer.paint(painter, m_canvas);
    m_detailRegions.paint(painter, m_canvas);
    if (!m_canvas.session().playback().isPlaying()) {
        m_canvas.cutTool().paint(painter);
        if (const Tool* tool = viewport.tool()) tool->paint(painter);
    }
    viewport.paintLegend(painter, size());
}

void SolidOverlay::paintMarks(QPainter& painter) {
    if (m_canvas.solid().picture().pose.cols() == 0) return;
    painter.save();
    paintCompass(painter, QPointF(46, m_canvas.height() - 46),
                 m_canvas.camera().view().topLeftCorner<3, 3>());
    painter.restore();
    const auto frame = m_canvas.session().motion().frame<3>();
    const Looks& looks = m_canvas.viewport().looks();
    if (looks.hidden || !frame) return;
    const Theme theme = m_canvas.viewport().theme();
    ShapePainter over(painter, m_canvas, theme);
    const Measure measure = looks.colours.measure;
    if (looks.map && isDistortion(measure)) over.worst(*frame, measure);
    if (m_markedOf == frame->shape) over.worst(*frame, m_marked);
    m_onion.setShown(looks.onionSkin);
    m_onion.paintOutlines(painter, m_canvas);
    if (const auto& built = *frame->built; built.cloud && looks.detail)
        over.dots(built.cloudEmbedding->carry(*frame->rest, frame->pose));
    m_canvas.viewport().paintPins(over);
}

}  // namespace wend
