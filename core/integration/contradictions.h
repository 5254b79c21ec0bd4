#pragma once

#include "core/motion/constraints.h"
#include "core/solver/constraint_rows.h"

namespace wend {

/// Returns the constraint rows of the points with these ids, in their order: each row is the combination of
/// vertices (weights that sum to 1) whose velocity is prescribed.
template <int Dim>
std::vector<ConstraintRow> rowsOf(const Constraints<Dim>& constraints, const std::vector<int>& ids);

/// Returns the sliders of the points with these ids.
template <int Dim>
Sliders slidersOf(const Constraints<Dim>& constraints, const std::vector<int>& ids);

/// Returns those of the points `sliding` that slide on surfaces and whose vertex none of the points `held`
/// holds.
template <int Dim>
std::vector<int> guidedAlone(const Constraints<Dim>& constraints, const std::vector<int>& held,
                             const std::vector<int>& sliding);

/// Throws InputError naming two handles that prescribe different motions for one point: linearly dependent
/// rows whose velocities are not the same combination. They are compared at several times between consecutive
/// breakpoints, on the trajectories from rest. Handles that agree are accepted: the solver drops the
/// redundant row. The mesh's welds are rows of velocity 0.
template <int Dim>
void requireConsistent(const Constraints<Dim>& constraints, const Points<Dim>& rest,
                       const Normalization<Dim>& units);

}  // namespace wend
