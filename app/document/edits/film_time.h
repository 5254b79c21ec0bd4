#pragma once

#include "app/document/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// The clock of a film has nothing to do with posing: a film has a length of its own, and gestures share it
/// in proportion to the way that they go. All functions are pure.

/// How far a motion goes, in the domain's units; turning and growing count at a radius of `arm`.
template <int Dim>
double pathLength(const Motion<Dim>& motion, double arm);
/// How far the shape is led from one pose to the next, all in all: where handles move at the same time, the
/// longest way counts. Handles that are points or regions have arms of their own, `arm` is that of all
/// others.
template <int Dim>
double pathLength(const std::vector<Handle<Dim>>& handles, double arm);

/// Whether somebody has said when things happen: motions rest between each other, overlap, go at unlike
/// paces, begin or end softly or have the rhythm of a hand. What is only posed follows one another, in
/// proportion to the ways. To spread the times anew changes what was timed.
bool hasOwnTiming(const Project& project);

/// What happens up to a time: motions that are under way are cut there, later ones go. Pins that come later
/// now come at the very end, those that would be let go of later hold on.
Project endedAt(const Project& project, double time);
/// The motions of one handle, cut at a time.
template <int Dim>
void endMotionsAt(Handle<Dim>& handle, double time);

/// The same poses by another clock: every time is mapped by the two straight lines [0, from] → [0, to] and
/// [from, end] → [to, end].
Project withTimesMoved(Project project, double from, double to);
/// The same poses in a film of another length.
Project withLength(Project project, double length);

}  // namespace wend
