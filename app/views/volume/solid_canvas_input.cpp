// Navigation and picking in a solid.
#include <QLocale>
#include <QMouseEvent>
#include <QWheelEvent>

#include "app/views/volume/solid_canvas.h"

namespace wend {

void SolidCanvas::navigate(QMouseEvent& event, bool pans) {
    if (pans)
        navigation().pressToPan(event);
    else if (event.type() == QEvent::MouseMove)
        m_fitted = false, VolumeView::mouseMoveEvent(&event);
    else if (event.type() == QEvent::MouseButtonRelease)
        VolumeView::mouseReleaseEvent(&event);
    else
        VolumeView::mousePressEvent(&event);
}

QString SolidCanvas::pointerText(const QPointF& at) {
    const bool busy = navigation().isGoingOn() || m_session.isDragging() || !m_session.frame<3>();
    const SolidHit hit = busy ? SolidHit{} : pick(at);
    if (!busy) emit pointedAt(hit.cell, hit.vertex, hit.point);
    if (hit.cell < 0) return {};
    const QLocale locale;
    const double minimum = 1e-9 * m_session.frame()->diagonal;
    const auto number = [&](double x) { return locale.toString(std::abs(x) < minimum ? 0.0 : x, 'g', 4); };
    QString text =
        QStringLiteral("%1, %2, %3").arg(number(hit.point.x()), number(hit.point.y()), number(hit.point.z()));
    text = tr("Cell %1").arg(hit.cell) + QStringLiteral("   ") + text;
    if (!m_viewport.looks().map) return text;
    const Measure measure = m_viewport.looks().colours.measure;
    const double value = shownValues(m_session, measure)[hit.cell];
    return measureName(measure, 3) + ' ' + measureText(measure, value) + QStringLiteral("   ") + text;
}

void SolidCanvas::wheelEvent(QWheelEvent* event) {
    m_fitted = false;
    VolumeView::wheelEvent(event);
}

}  // namespace wend
