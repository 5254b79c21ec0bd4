#include "app/panels/legend.h"
#include "app/session/shape.h"
#include "app/tools/pin_picking.h"
#include "app/tools/stiffness_marks.h"
#include "app/tools/velocity_arrows.h"
#include "app/view/canvas.h"
#include "app/view/overlay_painter.h"
#include "core/energy/distortion.h"

namespace wend {

void ShapeCanvas::paintShape(QPainter& painter) {
    if (!m_drawn) return;
    // While another view is being drawn, the last one stands in for it, moved and scaled.
    const RenderRequest& request = m_drawn->request;
    const double scale = m_view.zoom() / request.view.zoom();
    const QPointF origin = m_view.toWidget(request.view.toShape({0, 0}));
    painter.save();
    painter.setOpacity(m_dimmed ? 0.55 : 1);
    const QRectF target(origin, QSizeF(m_drawn->image.size()) / request.scale() * scale);
    const bool fits = request.view == m_view && request.coarseness == 1;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !fits);
    if (fits) {
        painter.drawImage(QPointF(0, 0), m_drawn->image);
    } else {  // Qt does not enlarge an image of fewer pixels than the screen's by its ratio
        painter.drawImage(target, m_drawn->image);
    }
    painter.restore();
}

/// A film that plays is seen without them.
void ShapeCanvas::paintHandles(QPainter& painter, OverlayPainter& overlay) {
    const int hovered = m_tool ? m_tool->hovered() : -1;
    overlay.paths(m_session, hovered);
    overlay.pins(m_session, m_animation, hovered,
                 [this](const PinView<2>& pin) { return wend::isCovered<2>(*this, pin); });
    if (m_tool) m_tool->paint(painter);
}

void ShapeCanvas::paintEvent(QPaintEvent*) {
    m_marksDue.stop();
    QPainter painter(this);
    const Theme theme = Theme::of(palette());
    Ground::Look look{m_view, size(), devicePixelRatioF(), {}, m_backdrop, theme.dark};
    if (m_session.document().picture()) look.paper = frameRect();
    m_ground.paint(painter, look, theme, m_session.isDragging() || m_session.playback().isPlaying());
    OverlayPainter overlay(painter, m_view, theme);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_hidden) m_onion.paintFills(painter, *this);
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintShape(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    if (const auto frame = m_session.frame<2>(); !m_hidden && frame) {
        if (m_map && isDistortion(m_measure))
            overlay.worst(*frame, worstOf(*frame->distortion, m_measure).cell);
        if (m_map && m_faults && !m_rest && !m_standIn) overlay.faults(*frame, *m_faults);
        if (m_marks || (m_map && m_measure == Measure::Stiffness))
            paintStiffnessMarks(painter, *this, size());
        if (m_arrows) paintVelocityArrows(painter, *this, m_session.velocity<2>(), size());
        m_layer.paint(painter, *this);
        m_detailRegions.paint(painter, *this);
        m_depthRegions.paint(painter, *this);
        m_onion.paintOutlines(painter, *this);
        if (!m_session.playback().isPlaying()) paintHandles(painter, overlay);
        if (hasLegend()) paintLegendCard(painter, size(), m_measure, m_range, palette(), 2);
    }
}

}  // namespace wend
