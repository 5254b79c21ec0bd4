#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace wend {

/// A point or a vector; lengths are in the domain's unit unless a comment says otherwise.
template <int Dim>
using Vec = Eigen::Matrix<double, Dim, 1>;
using Vec2 = Vec<2>;
/// Points above the engine are in space; those of pictures have z = 0.
using Vec3 = Vec<3>;
inline Vec3 inSpace(const Vec2& p) {
    return {p[0], p[1], 0};
}
inline const Vec3& inSpace(const Vec3& p) {
    return p;
}
/// Returns points of the plane in the coordinates of space.
inline std::vector<Vec3> inSpace(const std::vector<Vec2>& points) {
    std::vector<Vec3> all;
    all.reserve(points.size());
    for (const Vec2& p : points) all.push_back(inSpace(p));
    return all;
}
inline const std::vector<Vec3>& inSpace(const std::vector<Vec3>& points) {
    return points;
}
inline Vec2 inPlane(const Vec3& p) {
    return p.head<2>();
}

template <int Dim>
using Mat = Eigen::Matrix<double, Dim, Dim>;
using Mat2 = Mat<2>;
using Mat3 = Mat<3>;

/// The points of a shape, one column per vertex and contiguous, so that a shape, a velocity field or a stage
/// is one flat vector.
template <int Dim>
using Points = Eigen::Matrix<double, Dim, Eigen::Dynamic>;
using Points2 = Points<2>;
using Points3 = Points<3>;

/// The Dim + 1 vertex indices of a triangle or tetrahedron.
template <int Dim>
using Cell = std::array<int, Dim + 1>;

}  // namespace wend
