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

/// The cell under a pixel of a solid's view.
struct SolidHit {
    int cell = -1;
    int vertex = -1;  // the nearest corner
    Vec<3> point = Vec<3>::Zero();
};

/// Place of a vertex mark on the drawn surface.
struct VertexMark {
    Vec<3> at;
    bool hidden;
};

/// The view of a solid as tools see it.
class SolidSurface : public ShapeSurface<3> {
  public:
    virtual Ray ray(const QPointF& widget) const = 0;
    virtual Vec<3> viewDirection() const = 0;
    /// Returns the nearest drawn cell under a pixel; cell −1 if there is none.
    virtual SolidHit pick(const QPointF& widget) const = 0;
    /// Returns the drawn vertices that satisfy the test on screen positions, only visible ones if
    /// `visibleOnly`. Cut-off vertices are left out.
    virtual std::vector<int> verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                           bool visibleOnly) const = 0;
    /// Returns whether the solid is in front of the point, or the point is cut off.
    virtual bool isHidden(const Vec<3>& p) const = 0;
    /// Returns whether the point is in the removed part of a cut.
    virtual bool isCutOff(const Vec<3>& p) const = 0;
    /// Returns the visible place of a cell; nothing if it is covered or cut off.
    virtual std::optional<Vec<3>> placeOf(int cell) const = 0;
    /// Returns the marks of vertices that are not cut off.
    virtual std::vector<VertexMark> marksOf(const std::vector<int>& vertices) const = 0;
};

/// Returns the point under the pointer in the screen-parallel plane through p.
inline Vec<3> acrossTheScreen(const SolidSurface& surface, const Vec<3>& p, const QPointF& widget) {
    const Ray ray = surface.ray(widget);
    const Vec<3> normal = surface.viewDirection();
    return ray.origin + normal.dot(p - ray.origin) / normal.dot(ray.direction) * ray.direction;
}

}  // namespace wend
