#pragma once

#include "core/motion/constraints.h"
#include "core/solver/constraint_rows.h"

namespace wend {

template <int Dim>
std::vector<ConstraintRow> rowsOf(const Constraints<Dim>& constraints, const std::vector<int>& ids);

/// Throws InputError naming two handles that prescribe different motions for one point: linearly dependent
/// rows whose velocities are not the same combination. They are compared at some times between any two
/// breakpoints, on the trajectories that the points have from rest on. Handles that agree are fine: the
/// solver leaves the row out.
template <int Dim>
void requireConsistent(const Constraints<Dim>& constraints, const Points<Dim>& rest,
                       const Normalization<Dim>& units);

}  // namespace wend
