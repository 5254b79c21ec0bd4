#pragma once

#include <vector>

#include "app/session/motion/frame.h"
#include "core/mesh/point_locator.h"
#include "core/mesh/region.h"

namespace wend {

/// The barycentric coordinates of a point in a cell of a pose.
template <int Dim>
Location<Dim> locationIn(const PosedFrame<Dim>& frame, int cell, const Vec<Dim>& p);
/// The rotation of a cell from rest to the pose: the polar factor of its deformation gradient.
template <int Dim>
Mat<Dim> cellRotation(const PosedFrame<Dim>& frame, int cell);

/// The vertices of the rest mesh that a region holds, increasing.
template <int Dim>
std::vector<int> verticesInside(const Region<Dim>& region, const SimplicialMesh<Dim>& rest);

/// x ↦ A x + b.
template <int Dim>
struct CarryingOf {
    Mat<Dim> A = Mat<Dim>::Identity();
    Vec<Dim> b = Vec<Dim>::Zero();

    Vec<Dim> operator()(const Vec<Dim>& x) const { return A * x + b; }
};
/// The affine map that takes points from rest to a pose, by least squares; only shifts where they are too few
/// or lie in a plane (a line). Points that a handle has moved as one are met exactly.
template <int Dim>
CarryingOf<Dim> carryingBetween(const std::vector<Vec<Dim>>& rest, const std::vector<Vec<Dim>>& posed);
/// The same for vertices of a frame; from rest to its pose.
CarryingOf<3> carryingOf(const PosedFrame<3>& frame, const std::vector<int>& vertices);

/// How large a solid is, or the part of it whose vertices are given: the volume of the cells and the area of
/// the outer triangles all of whose vertices are among them.
struct SolidSize {
    double volume = 0, area = 0;
};
SolidSize sizeOf(const PosedFrame<3>& frame, const Points<3>& points);
SolidSize sizeOf(const PosedFrame<3>& frame, const Points<3>& points, const std::vector<int>& vertices);

}  // namespace wend
