#include "app/views/canvas/view_transform.h"

#include <algorithm>

namespace wend {

QRectF boxOf(const Points2& points) {
    const Vec2 low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
    return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

QPointF ViewTransform::toWidget(const Vec2& p) const {
    return m_origin + QPointF(p.x() * m_zoom, (m_up ? -p.y() : p.y()) * m_zoom);
}

Vec2 ViewTransform::toShape(const QPointF& widget) const {
    const QPointF d = (widget - m_origin) / m_zoom;
    return {d.x(), m_up ? -d.y() : d.y()};
}

QTransform ViewTransform::matrix() const {
    return {m_zoom, 0, 0, m_up ? -m_zoom : m_zoom, m_origin.x(), m_origin.y()};
}

void ViewTransform::setZoom(double zoom, const QPointF& fixed) {
    const Vec2 below = toShape(fixed);
    m_zoom = std::clamp(zoom, m_minimum, m_maximum);
    m_origin += fixed - toWidget(below);
}

void ViewTransform::fit(const QRectF& shape, const QSizeF& widget, double margin) {
    if (shape.isEmpty() || widget.width() <= 2 * margin || widget.height() <= 2 * margin) return;
    const double zoom = std::min((widget.width() - 2 * margin) / shape.width(),
                                 (widget.height() - 2 * margin) / shape.height());
    m_zoom = std::clamp(zoom, m_minimum, m_maximum);
    const QPointF centre(widget.width() / 2, widget.height() / 2);
    m_origin = {};
    m_origin = centre - toWidget({shape.center().x(), shape.center().y()});
}

void ViewTransform::setZoomLimits(double minimum, double maximum) {
    m_minimum = minimum;
    m_maximum = maximum;
}

}  // namespace wend
