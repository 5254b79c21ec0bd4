#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace wend::formats {

/// Returns the sign of det [b − a, c − a] for points of the plane, exact for all doubles (J. R. Shewchuk,
/// Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997).
int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// Returns triangles that exactly fill a polygon and are oriented as it is: the fan of its first corner if
/// that is inside, else ears are cut off, the best shaped first. Corners that repeat the one before them are
/// left out. Three corners are returned as they are, and a polygon all of whose corners are on a line as its
/// fan; others take quadratic time. Throws InputError for a polygon that crosses itself or, with more than
/// four corners, whose corners are farther from a plane than 0.15 of its size.
std::vector<std::array<int, 3>> splitPolygon(const Eigen::Matrix3Xd& points, std::span<const int> corners);

}  // namespace wend::formats
