#pragma once

#include <QPointF>
#include <algorithm>
#include <functional>
#include <optional>

#include "app/tools/shape_surface.h"

namespace wend {

struct Ray {
    Vec<3> origin, direction;  // direction has length 1
};

/// What lies under a pixel of the view of a solid.
struct SolidHit {
    int cell = -1;
    int vertex = -1;  // the nearest corner
    Vec<3> point = Vec<3>::Zero();
};

/// Where a vertex is marked: on the surface that is drawn.
struct VertexMark {
    Vec<3> at;
    bool hidden;
};

/// The view of a solid as tools see it.
class SolidSurface : public ShapeSurface<3> {
  public:
    virtual Ray ray(const QPointF& widget) const = 0;
    virtual Vec<3> viewDirection() const = 0;
    /// What is drawn nearest under a pixel, cell −1 if nothing is.
    virtual SolidHit pick(const QPointF& widget) const = 0;
    /// The vertices that are drawn where the test says; only those that nothing hides if `visibleOnly`. A cut
    /// takes away what is cut off.
    virtual std::vector<int> verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                           bool visibleOnly) const = 0;
    /// True if the solid lies in front of the point, or a cut has taken it away.
    virtual bool isHidden(const Vec<3>& p) const = 0;
    /// True if it lies in the part that a cut takes away.
    virtual bool isCutOff(const Vec<3>& p) const = 0;
    /// Where a cell is seen; nothing if others lie in front of it, or a cut has taken it away.
    virtual std::optional<Vec<3>> placeOf(int cell) const = 0;
    /// Of vertices that no cut has taken away.
    virtual std::vector<VertexMark> marksOf(const std::vector<int>& vertices) const = 0;
};

/// Where the screen's plane through a point is under the pointer.
inline Vec<3> acrossTheScreen(const SolidSurface& surface, const Vec<3>& p, const QPointF& widget) {
    const Ray ray = surface.ray(widget);
    const Vec<3> normal = surface.viewDirection();
    return ray.origin + normal.dot(p - ray.origin) / normal.dot(ray.direction) * ray.direction;
}

}  // namespace wend
