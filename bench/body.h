#pragma once

#include <memory>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "core/motion/handle.h"
#include "core/solver/constraint_rows.h"

namespace wend {

/// Returns a box with one corner at 0, meshed by the program's own meshers to about so many vertices.
SimplicialMesh<2> meshBox(const Vec2& size, int vertices);
SimplicialMesh<3> meshBox(const Vec3& size, int vertices);

/// The body that the benchmark bends: a strip of 4 : 1 in the plane, or a bar of 4 : 1 : 1 in space, meshed
/// by the program's own meshers to about so many vertices, with diagonal 1. The left end is held; the right
/// end moves on a half circle about a point above the middle (2D: the strip bends by 180°) or turns by 180°
/// about the bar's axis (3D: it twists).
template <int Dim>
struct Body {
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::vector<Handle<Dim>> handles;  // "left", "right"
    Vec<Dim> centre;                   // of the turn
};
template <int Dim>
Body<Dim> makeBody(int vertices);

/// The constrained vertices as rows, and their velocities at the start.
template <int Dim>
struct BodyRows {
    std::vector<ConstraintRow> rows;
    Points<Dim> velocities;
};
template <int Dim>
BodyRows<Dim> startRows(const Body<Dim>& body);

}  // namespace wend
