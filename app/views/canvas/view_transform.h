#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QTransform>

#include "core/base/types.h"

namespace wend {

/// Maps between domain and widget coordinates: zoom is widget pixels per unit; y may point up (meshes without
/// a picture).
class ViewTransform {
  public:
    double zoom() const { return m_zoom; }
    void setPointsUp(bool up) { m_up = up; }

    QPointF toWidget(const Vec2& p) const;
    Vec2 toShape(const QPointF& widget) const;
    QTransform matrix() const;

    void pan(const QPointF& by) { m_origin += by; }
    /// Changes the zoom around the fixed widget point `fixed`.
    void setZoom(double zoom, const QPointF& fixed);
    /// Fits a rectangle of the domain into the widget, with a margin in pixels.
    void fit(const QRectF& shape, const QSizeF& widget, double margin);
    void setZoomLimits(double minimum, double maximum);

    bool operator==(const ViewTransform&) const = default;

  private:
    QPointF m_origin;  // of the domain, in the widget
    double m_zoom = 1;
    double m_minimum = 0.01, m_maximum = 64;
    bool m_up = false;
};

QRectF boxOf(const Points2& points);

}  // namespace wend
