#pragma once

#include <QPainterPath>
#include <optional>

#include "app/tools/drawn_outline.h"
#include "app/tools/shape_tool.h"

namespace wend {

/// The part that a handle will hold: in a picture an area of the screen, which becomes a polygon of the rest
/// shape; in a solid vertices in increasing order.
template <int Dim>
using HeldPart = std::conditional_t<Dim == 2, QPainterPath, std::vector<int>>;

/// Returns the part of the shape that is drawn over; of a solid only what is visible, unless `through`.
template <int Dim>
HeldPart<Dim> drawnPart(const SurfaceOf<Dim>& surface, const DrawnOutline& outline, bool through);
template <>
QPainterPath drawnPart<2>(const ToolSurface& surface, const DrawnOutline& outline, bool through);
template <>
std::vector<int> drawnPart<3>(const SolidSurface& surface, const DrawnOutline& outline, bool through);
/// Both lists are in increasing order.
std::vector<int> joined(const std::vector<int>& a, const std::vector<int>& b);
/// Takes hold of it as a new handle; false, with a notice, if it is nothing.
template <int Dim>
bool holdPart(SurfaceOf<Dim>& surface, const HeldPart<Dim>& part);
/// Shift adds to the single selected handle, Ctrl subtracts. Returns false if a new handle is needed: with
/// neither key, or with Shift and nothing to add to.
template <int Dim>
bool changePart(SurfaceOf<Dim>& surface, const HeldPart<Dim>& part, Qt::KeyboardModifiers with);

/// Marks vertices of a solid and shows their number.
void paintCaught(QPainter& painter, SolidSurface& surface, const std::vector<int>& vertices,
                 const QPointF& at);

}  // namespace wend
