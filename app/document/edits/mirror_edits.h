#pragma once

#include "core/motion/handle.h"

namespace wend {

/// Mirrors one coordinate, at an upright or level line of a picture, or a plane in space across an axis.
template <int Dim>
struct Mirror {
    int axis = 0;
    double at = 0;

    /// Of a place, and of a direction.
    Vec<Dim> operator()(Vec<Dim> p) const;
    Vec<Dim> along(Vec<Dim> direction) const;
};

/// What is a mirror image of the motion in every respect: also of how it turns.
template <int Dim>
Motion<Dim> mirrored(const Motion<Dim>& motion, const Mirror<Dim>& mirror);
template <int Dim>
Region<Dim> mirrored(const Region<Dim>& region, const Mirror<Dim>& mirror);

}  // namespace wend
