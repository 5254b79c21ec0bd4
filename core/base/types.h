#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace wend {

/// A point or a vector; lengths are in the domain's unit unless a comment says otherwise.
template <int Dim>
using Vec = Eigen::Matrix<double, Dim, 1>;
/// Points above the engine are in space; those of pictures have z = 0.
using Vec3 = Vec<3>;
inline Vec3 inSpace(const Vec<2>& p) {
    return {p[0], p[1], 0};
}
inline const Vec3& inSpace(const Vec3& p) {
    return p;
}
/// Returns points of the plane in the coordinates of space.
inline std::vector<Vec3> inSpace(const std::vector<Vec<2>>& points) {
    std::vector<Vec3> all;
    all.reserve(points.size());
    for (const Vec<2>& p : points) all.push_back(inSpace(p));
    return all;
}
inline const std::vector<Vec3>& inSpace(const std::vector<Vec3>& points) {
    return points;
}
inline Vec<2> inPlane(const Vec3& p) {
    return p.head<2>();
}

template <int Dim>
using Mat = Eigen::Matrix<double, Dim, Dim>;

/// The points of a shape, one column per vertex and contiguous, so that a shape, a velocity field or a stage
/// is one flat vector.
template <int Dim>
using Points = Eigen::Matrix<double, Dim, Eigen::Dynamic>;

/// The Dim + 1 vertex indices of a triangle or tetrahedron.
template <int Dim>
using Cell = std::array<int, Dim + 1>;

}  // namespace wend
