#pragma once

#include "core/motion/handle.h"

namespace wend {

/// The map x ↦ to + scale (x − from): where the surroundings of a handle are in another shape.
template <int Dim>
struct Carrying {
    Vec<Dim> from = Vec<Dim>::Zero(), to = Vec<Dim>::Zero();
    double scale = 1;

    Vec<Dim> operator()(const Vec<Dim>& p) const { return to + scale * (p - from); }
};

/// Returns C ∘ M ∘ C⁻¹ for a motion M: paths and displacements are scaled, angles and times stay. Files of
/// the motion are named no more.
template <int Dim>
Motion<Dim> carried(const Motion<Dim>& motion, const Carrying<Dim>& carry);

/// Returns C(R) for a region R.
template <int Dim>
Region<Dim> carried(const Region<Dim>& region, const Carrying<Dim>& carry);

}  // namespace wend
