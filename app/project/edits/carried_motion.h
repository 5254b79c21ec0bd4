#pragma once

#include "app/project/pin.h"

namespace wend {

/// The map x ↦ to + scale (x − from): where the surroundings of a handle are in another shape.
struct Carrying {
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double scale = 1;

    Vec3 operator()(const Vec3& p) const { return to + scale * (p - from); }
};

/// Returns C ∘ M ∘ C⁻¹ for a motion M: paths and displacements are scaled, angles and times stay. Files of
/// the motion are named no more.
PinMotion carried(const PinMotion& motion, const Carrying& carry);

/// Returns C(R) for a region R.
Region<3> carried(const Region<3>& region, const Carrying& carry);

}  // namespace wend
