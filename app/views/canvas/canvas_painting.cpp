// This file draws pictures.
#include "app/engine/shape/shape.h"
#include "app/style/smooth_map.h"
#include "app/tools/paint/stiffness_marks.h"
#include "app/tools/velocity_arrows.h"
#include "app/views/canvas/canvas.h"
#include "app/views/shape/shape_painter.h"

namespace wend {

void ShapeCanvas::paintShape(QPainter& painter) {
    if (!m_drawn) return;
    // Until the new view is drawn, shows the last one, moved and scaled.
    const RenderRequest& request = m_drawn->request;
    const double scale = m_view.zoom() / request.view.zoom();
    const QPointF origin = m_view.toWidget(request.view.toShape({0, 0}));
    painter.save();
    painter.setOpacity(m_viewport.isDimmed() ? 0.55 : 1);
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

/// Pins are hidden during playback.
void ShapeCanvas::paintOver(QPainter& painter) {
    const auto frame = m_session.frame<2>();
    const Looks& looks = m_viewport.looks();
    if (looks.hidden || !frame) return;
    const Theme theme = Theme::of(palette());
    const Measure measure = looks.colours.measure;
    ShapePainter over(painter, *this, theme);
    if (looks.map && isDistortion(measure)) over.worst(*frame, measure);
    if (looks.map && m_faults && !looks.rest && !looks.standIn)
        paintFaults(painter, *this, *frame, *m_faults);
    if (looks.marks || (looks.map && measure == Measure::Stiffness))
        paintStiffnessMarks(painter, *this, size());
    if (looks.arrows) paintVelocityArrows(painter, *this, m_session.velocity<2>(), size());
    m_layer.setLayer(looks.layer);
    m_layer.paint(painter, *this);
    m_detailRegions.paint(painter, *this);
    m_depthRegions.paint(painter, *this);
    m_onion.paintOutlines(painter, *this);
    if (!m_session.playback().isPlaying()) {
        if (looks.groups) over.groups(*looks.groups);
        over.paths(m_viewport.hovered());
        over.pins(m_viewport.hovered(), m_viewport.named());
        if (Tool* tool = m_viewport.tool()) tool->paint(painter);
    }
    m_viewport.paintLegend(painter, size());
}

void ShapeCanvas::paintEvent(QPaintEvent*) {
    m_viewport.marksPainted();
    QPainter painter(this);
    const Looks& looks = m_viewport.looks();
    const Theme theme = Theme::of(palette());
    Ground::Look look{m_view, size(), devicePixelRatioF(), {}, looks.backdrop, theme.dark};
    if (m_session.document().picture()) look.paper = frameRect();
    m_ground.paint(painter, look, theme, m_session.isDragging() || m_session.playback().isPlaying());
    m_onion.setShown(looks.onionSkin);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!looks.hidden) m_onion.paintFills(painter, *this);
    const auto frame = drawnFrame();
    const bool isMapped = frame && frame != m_unbent && m_viewport.showsMap();
    if (theme.dark && isMapped && !isPainted(looks.colours.measure))
        m_onion.paintRim(painter, *this, *frame);  // the dark end of a map is as dark as the ground
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintShape(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOver(painter);
}

}  // namespace wend
