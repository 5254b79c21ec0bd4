#pragma once

#include <QPainterPath>
#include <optional>

#include "app/tools/drawn_outline.h"
#include "app/tools/shape_tool.h"

namespace wend {

/// Return the part of the shape that is drawn over, which a handle will hold: of a picture an area of the
/// screen, which becomes a polygon of the rest shape; of a solid its vertices in increasing order, only
/// visible ones unless `through`.
QPainterPath drawnPart(const PictureShapeView& view, const DrawnOutline& outline);
std::vector<int> drawnPart(const SolidShapeView& view, const DrawnOutline& outline, bool through);
/// Joins two lists, both in increasing order.
std::vector<int> joined(const std::vector<int>& a, const std::vector<int>& b);
/// Take hold of it as a new handle; false, with a notice, if it is nothing.
bool holdPart(PictureShapeView& view, const QPainterPath& part);
bool holdPart(SolidShapeView& view, const std::vector<int>& part);
/// Shift adds to the single selected handle, Ctrl subtracts. Return false if a new handle is needed: with
/// neither key, or with Shift and nothing to add to.
bool changePart(PictureShapeView& view, const QPainterPath& part, Qt::KeyboardModifiers with);
bool changePart(SolidShapeView& view, const std::vector<int>& part, Qt::KeyboardModifiers with);

/// Marks vertices of a solid and shows their number.
void paintCaught(QPainter& painter, SolidShapeView& view, const std::vector<int>& vertices,
                 const QPointF& at);

}  // namespace wend
