#pragma once

#include "app/tools/shape_view.h"

namespace wend {

/// The canvas as tools see it that work on pictures alone: with points of the plane.
class PictureShapeView : public ShapeView {
  public:
    virtual Vec2 toShape(const QPointF& widget) const = 0;
    virtual QPointF toWidget(const Vec2& p) const = 0;

    int dimension() const override { return 2; }
    QPointF onScreen(const Vec3& p) const override { return toWidget(inPlane(p)); }
    Ray ray(const QPointF& widget) const override {
        return {inSpace(toShape(widget)) + Vec3::UnitZ(), -Vec3::UnitZ()};
    }
    Vec3 viewDirection() const override { return -Vec3::UnitZ(); }
    std::optional<Vec3> placeOf(const ShapeFrame& frame, int cell) const override {
        return frame.centreOf(cell);
    }
};

}  // namespace wend
