#pragma once

#include <QPointF>
#include <optional>

#include "app/session/shape_session.h"
#include "core/mesh/point_locator.h"

namespace wend {

/// What lies under the pointer: where on the shape, and where that is seen.
template <int Dim>
struct Touch {
    Location<Dim> place;
    Vec<Dim> point;
};

/// The view of a picture or of a solid, as tools see it that work on both.
template <int Dim>
class ShapeSurface {
  public:
    virtual ~ShapeSurface() = default;
    virtual ShapeSession& session() = 0;
    virtual QPointF toWidget(const Vec<Dim>& p) const = 0;
    /// Length in the domain of a pixel of the screen at a point.
    virtual double pixelSize(const Vec<Dim>& at) const = 0;
    virtual std::optional<Touch<Dim>> touch(const QPointF& widget) const = 0;
    /// The session's frame, with the material that is being painted.
    virtual PosedPtr<Dim> shownFrame() const = 0;
    /// Shows another material until the motion with it is there, or the project changes; `lasts`: it is what
    /// the next change brings.
    virtual void showMaterial(std::shared_ptr<const Material<Dim>> painted, bool lasts = false) = 0;
    virtual void redraw() = 0;
};

}  // namespace wend
