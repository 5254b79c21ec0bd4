#pragma once

#include <vector>

#include "app/session/frame.h"
#include "core/mesh/point_locator.h"
#include "core/mesh/region.h"

namespace wend {

/// The barycentric coordinates of a point in a cell of a pose.
Location<3> locationIn(const PosedFrame<3>& frame, int cell, const Vec<3>& p);
/// The rotation of a cell from rest to the pose: the polar factor of its deformation gradient.
Mat<3> cellRotation(const PosedFrame<3>& frame, int cell);

/// The vertices of the rest mesh that a region holds, increasing.
std::vector<int> verticesIn(const Region<3>& region, const SimplicialMesh<3>& rest);

/// x ↦ A x + b.
struct Carrying {
    Mat<3> A = Mat<3>::Identity();
    Vec<3> b = Vec<3>::Zero();

    Vec<3> operator()(const Vec<3>& x) const { return A * x + b; }
};
/// The affine map that takes points from rest to a pose, by least squares; only shifts where they are too few
/// or lie in a plane. Points that a handle has moved as one are met exactly.
Carrying carryingOf(const std::vector<Vec<3>>& rest, const std::vector<Vec<3>>& posed);

/// The same for vertices of a frame; from rest to its pose.
Carrying carryingOf(const PosedFrame<3>& frame, const std::vector<int>& vertices);

/// How large a solid is, or the part of it whose vertices are given: the volume of the cells and the area of
/// the outer triangles all of whose vertices are among them.
struct SolidSize {
    double volume = 0, area = 0;
};
SolidSize sizeOf(const PosedFrame<3>& frame, const Points<3>& points);
SolidSize sizeOf(const PosedFrame<3>& frame, const Points<3>& points, const std::vector<int>& vertices);

}  // namespace wend
