#pragma once

#include <string>
#include <vector>

#include "app/document/project.h"

namespace wend {

/// What the gestures of the window make of a project: pure functions from a project to the next one.

bool hasMotion(const Design<2>& design);
/// When the next gesture begins: the end of the project once something moves, 0 before.
double motionEnd(const Project& project);
/// True if the handle holds the shape at time t; one that ends at t is gone.
bool isActive(const Handle<2>& handle, double t);
/// True if both take hold of the same points.
bool samePlace(const Handle<2>& a, const Handle<2>& b);
/// "Pin 1", "Pin 2" …: the first that no handle has.
std::string freePinName(const Design<2>& design);

/// A handle of one point of the rest shape: there from the start, or from the end of the motion if there is
/// one.
Project withPin(const Project& project, const Vec<2>& rest, const std::string& name);

/// Handles that go away together: removed as if never there while nothing has moved (or if they never acted),
/// else let go of at the end.
Project withoutHandles(const Project& project, const std::vector<int>& handles);

/// A drag of several handles along one path of offsets, the first zero: a Recorded motion at constant speed
/// in a new window of length 1 at the end. `starts` is where each handle is at the gesture's start.
Project withStroke(const Project& project, const std::vector<int>& handles, const std::vector<Vec<2>>& starts,
                   const std::vector<Vec<2>>& offsets);
/// Puts another offset at the end of the last motion of the handles, which withStroke() made.
Project withLongerStroke(const Project& project, const std::vector<int>& handles, const Vec<2>& step);

/// The points that are needed for a polyline within `tolerance` of the given one (Douglas and Peucker); ends
/// are kept, neighbours that coincide are merged.
std::vector<Vec<2>> simplified(const std::vector<Vec<2>>& path, double tolerance);

/// The first time from which two lists of handles prescribe something different; infinity if never. −infinity
/// if the rest shape's constraints themselves differ.
double firstDifference(const std::vector<Handle<2>>& a, const std::vector<Handle<2>>& b);

}  // namespace wend
