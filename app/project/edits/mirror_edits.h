#pragma once

#include "app/project/pin.h"

namespace wend {

/// Mirrors one coordinate, at an upright or level line of a picture, or a plane in space across an axis.
struct Mirror {
    int axis = 0;
    double at = 0;

    /// Mirrors a place, and a direction.
    Vec3 operator()(Vec3 p) const;
    Vec3 along(Vec3 direction) const;
};

/// Returns the mirror image of the motion, with its rotations.
PinMotion mirrored(const PinMotion& motion, const Mirror& mirror);
Region<3> mirrored(const Region<3>& region, const Mirror& mirror);

}  // namespace wend
