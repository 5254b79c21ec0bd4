#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/types.h"

namespace wend {

/// Returns the signed solid angle of a triangle seen from p (van Oosterom and Strackee 1983): 4π in total for
/// each time that a closed surface encloses p.
inline double solidAngle(const Vec3& p, const Vec3& x, const Vec3& y, const Vec3& z) {
    const Vec3 a = x - p, b = y - p, c = z - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double det = a.dot(b.cross(c));
    const double den = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    return 2 * std::atan2(det, den);
}

}  // namespace wend
