#pragma once

#include <functional>

#include "app/tools/shape_view.h"

namespace wend {

/// The cell under a pixel of a solid's view.
struct SolidHit {
    int cell = -1;
    int vertex = -1;  // the nearest corner
    Vec3 point = Vec3::Zero();
};

/// The view of a solid as tools see it that work on solids alone.
class SolidShapeView : public ShapeView {
  public:
    int dimension() const override { return 3; }
    QPointF toWidget(const Vec3& p) const { return onScreen(p); }
    /// Returns the nearest drawn cell under a pixel; cell −1 if there is none.
    virtual SolidHit pick(const QPointF& widget) const = 0;
    /// Returns the drawn vertices that satisfy the test on screen positions, only visible ones if
    /// `visibleOnly`. Cut-off vertices are left out.
    virtual std::vector<int> verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                           bool visibleOnly) const = 0;
};

}  // namespace wend
