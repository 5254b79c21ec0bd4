// What lies over a solid.
#include "app/panels/legend.h"
#include "app/view/volume/solid_canvas.h"
#include "app/view/volume/solid_painter.h"
#include "core/energy/distortion.h"

namespace wend {

void SolidCanvas::paintOver(QPainter& painter) {
    m_marksDue.stop();
    paintMarks(painter);
    if (m_hidden || !m_session.frame<3>()) return;
    m_layer.paint(painter, *this);
    if (!m_session.playback().isPlaying()) {
        m_cutTool.paint(painter);
        if (m_tool) m_tool->paint(painter);
    }
    if (hasLegend()) paintLegendCard(painter, size(), m_measure, m_range, palette(), 3);
}

void SolidCanvas::paintMarks(QPainter& painter) {
    const auto frame = m_session.frame<3>();
    if (shown().pose.cols() == 0) return;
    const Theme theme = Theme::of(palette());
    SolidPainter painterOfSolid(painter, *this, theme);
    painter.save();
    painterOfSolid.compass(QPointF(46, height() - 46), camera().view().topLeftCorner<3, 3>());
    painter.restore();
    if (m_hidden || !frame) return;
    if (m_map && isDistortion(m_measure))
        painterOfSolid.worst(*frame, worstOf(*frame->distortion, m_measure).cell);
    if (m_pointedOf == frame->shape) painterOfSolid.worst(*frame, m_pointedCell);
    m_onion.paintOutlines(painter, *this);
    if (m_session.playback().isPlaying()) return;  // a film that plays is seen without pins
    painterOfSolid.paths();
    painterOfSolid.pins(m_animation, m_tool ? m_tool->hovered() : -1);
}

void SolidCanvas::paintLegend(QPainter& painter) const {
    if (!hasLegend()) return;
    const QColor colour = Theme::of(palette()).secondText;
    painter.setPen(colour);
    constexpr QRect kBar(24, 24, 240, 40);
    painter.drawText(kBar.bottomLeft(), measureName(m_measure, 3));
    wend::paintLegend(painter, kBar, m_measure, m_range, colour);
}

}  // namespace wend
