#pragma once

#include "core/motion/constraints.h"
#include "core/solver/constraint_rows.h"

namespace wend {

/// Returns the constraint rows of the points with these ids, in their order: each row is the combination of
/// vertices (weights that sum to 1) whose velocity is prescribed. The ids are indices of
/// Constraints::points(); row i belongs to ids[i], and no id gives no row.
template <int Dim>
std::vector<ConstraintRow> rowsOf(const Constraints<Dim>& constraints, const std::vector<int>& ids);

/// Returns the sliders of the points with these ids, in their order. The points must be vertices. A guided
/// one has its direction at rest, see VelocitySolver::setDirections().
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
/// redundant row. The mesh's welds are rows of velocity 0. Velocities agree up to 1e-7 of the largest one
/// that takes part. Shapes without dependent rows cost one elimination; sliding points are not compared.
template <int Dim>
void requireConsistent(const Constraints<Dim>& constraints, const Points<Dim>& rest,
                       const Normalization<Dim>& units);

}  // namespace wend
