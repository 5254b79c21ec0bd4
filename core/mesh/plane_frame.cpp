#include "core/mesh/plane_frame.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/mesh/decompositions.h"

namespace wend {
namespace {

constexpr double kFlat = 1e-6;  // of the diagonal

/// Returns the vertices that triangles have, in their order.
Points3 usedPoints(const Points3& points, const std::vector<std::array<int, 3>>& triangles) {
    std::vector<char> isUsed(static_cast<std::size_t>(points.cols()), 0);
    for (const auto& t : triangles)
        for (const int v : t) isUsed[static_cast<std::size_t>(v)] = 1;
    std::vector<int> used;
    for (int v = 0; v < points.cols(); ++v)
        if (isUsed[static_cast<std::size_t>(v)]) used.push_back(v);
    return points(Eigen::all, used);
}

/// Returns the frame across the coordinate axis k: the other two axes, in their order.
PlaneFrame frameAcross(int k) {
    PlaneFrame frame;
    frame.axes.setZero();
    int column = 0;
    for (int axis = 0; axis < 3; ++axis) frame.axes(axis, axis == k ? 2 : column++) = 1;
    return frame;
}

/// Returns a frame across a unit vector.
PlaneFrame frameAcross(const Vec3& normal) {
    int largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    const Vec3 n = normal[largest] < 0 ? Vec3(-normal) : normal;
    const Vec3 along = std::abs(n.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    PlaneFrame frame;
    frame.axes.col(0) = (along - n.dot(along) * n).normalized();
    frame.axes.col(1) = n.cross(frame.axes.col(0));
    frame.axes.col(2) = n;
    return frame;
}

}  // namespace

Points3 PlaneFrame::moved(const Points3& points, const Points2& moved) const {
    Points3 result = points;
    for (int k = 0; k < 2; ++k) {
        int axis = 0;
        if (axes.col(k).cwiseAbs().maxCoeff(&axis) == 1)
            result.row(axis) = moved.row(k);
        else
            result += axes.col(k) * (moved.row(k) - axes.col(k).transpose() * points);
    }
    return result;
}

/// Tries the coordinate planes first, so that coordinates stay those of the file, and then the plane of least
/// squares.
std::optional<PlaneFrame> planeOf(const Points3& points, const std::vector<std::array<int, 3>>& triangles) {
    if (triangles.empty()) return std::nullopt;
    const Points3 used = usedPoints(points, triangles);
    const Vec3 spread = used.rowwise().maxCoeff() - used.rowwise().minCoeff();
    const double tolerance = kFlat * spread.stableNorm();
    for (const int k : {2, 1, 0})
        if (spread[k] <= tolerance) return frameAcross(k);
    const Points3 centred = used.colwise() - Vec3(used.rowwise().mean());
    const double scale = spread.maxCoeff();
    if (!std::isfinite(scale)) return std::nullopt;
    const Points3 unit = centred / scale;
    const PlaneFrame frame = frameAcross(Vec3(principalAxes<3>(unit * unit.transpose()).axes.col(0)));
    const auto heights = (frame.axes.col(2).transpose() * centred).eval();
    if (heights.maxCoeff() - heights.minCoeff() > tolerance) return std::nullopt;
    return frame;
}

}  // namespace wend
