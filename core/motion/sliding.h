#pragma once

#include "core/motion/constraints.h"

namespace wend {

/// Returns the surface on which a handle's points slide. Throws InputError for points inside cells, and for a
/// handle that a surface cannot follow: one that begins later, or moves by a field.
template <int Dim>
std::shared_ptr<const GuideSurface<Dim>> surfaceOf(const Handle<Dim>& handle,
                                                   const std::vector<ConstrainedPoint>& points,
                                                   const SimplicialMesh<Dim>& rest);

/// Returns the points with the parts of the surface on which they slide, once for each direction in which
/// they are held there. Throws InputError for a vertex that is too far from the surface. The shape has size
/// 1: 1e-6 of it is near enough to a sharp line or corner to stay there, and more than 1e-2 too far from the
/// surface.
template <int Dim>
std::vector<ConstrainedPoint> onSurface(const GuideSurface<Dim>& surface,
                                        const std::vector<ConstrainedPoint>& points, const Points<Dim>& rest);

}  // namespace wend
