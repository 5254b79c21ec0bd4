#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/types.h"

namespace wend {

/// The plane of a flat mesh in space. A point p has the coordinates axesᵀ p: two in the plane, and the height
/// along its normal.
struct PlaneFrame {
    Mat3 axes = Mat3::Identity();  // orthogonal: both directions of the plane and its normal

    /// Returns whether coordinates in the plane are x and y.
    bool isXy() const { return axes == Mat3::Identity(); }
    Points3 toPlane(const Points3& points) const {
        return isXy() ? points : Points3(axes.transpose() * points);
    }
    /// Returns where the points of space are once their coordinates in the plane are `moved`. Their height
    /// stays, and so do the bits of points whose coordinates are the same.
    Points3 moved(const Points3& points, const Points2& moved) const;
};

/// Returns the plane that holds the vertices of the triangles, up to 1e-6 of the diagonal of their bounding
/// box; nothing if there is none. If it is parallel to two coordinate axes, these are its directions:
/// coordinates in it are those of the file. Else the first direction is as near as possible to the x axis (to
/// the y axis, in planes that are nearly across x).
std::optional<PlaneFrame> planeOf(const Points3& points, const std::vector<std::array<int, 3>>& triangles);

}  // namespace wend
