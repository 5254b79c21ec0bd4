#pragma once

#include "core/motion/handle.h"

namespace wend {

/// Mirrors one coordinate, at an upright or level line of a picture, or a plane in space across an axis.
template <int Dim>
struct Mirror {
    int axis = 0;
    double at = 0;

    /// Mirrors a place, and a direction.
    Vec<Dim> operator()(Vec<Dim> p) const;
    Vec<Dim> along(Vec<Dim> direction) const;
};

/// Returns the mirror image of the motion, with its rotations.
template <int Dim>
Motion<Dim> mirrored(const Motion<Dim>& motion, const Mirror<Dim>& mirror);
template <int Dim>
Region<Dim> mirrored(const Region<Dim>& region, const Mirror<Dim>& mirror);

}  // namespace wend
