#pragma once

#include <string>
#include <vector>

#include "app/document/grip.h"
#include "app/document/project.h"

namespace wend {

/// What the gestures of the window make of a project: pure functions from a project to the next one. Those
/// that take points are of the project's own dimension.

template <int Dim>
bool hasMotion(const Design<Dim>& design);
/// When the next gesture begins: the end of the project once something moves, 0 before.
double motionEnd(const Project& project);
/// True if the handle holds the shape at time t; one that ends at t is gone.
template <int Dim>
bool isActive(const Handle<Dim>& handle, double t);
/// True if both take hold of the same points.
template <int Dim>
bool samePlace(const Handle<Dim>& a, const Handle<Dim>& b);
/// "Pin 1", "Pin 2" …: the first that no handle has.
template <int Dim>
std::string freePinName(const Design<Dim>& design, const std::string& kind = "Pin");

/// A handle that holds from the start, or from the end of the motion if there is one.
template <int Dim>
Project withHandle(const Project& project, Placement<Dim> at, const std::string& name);
/// A handle of one point of the rest shape.
template <int Dim = 2>
Project withPin(const Project& project, const Vec<Dim>& rest, const std::string& name);
/// Another name, or other points to hold.
template <int Dim>
Project withHandlePlace(const Project& project, int handle, Placement<Dim> at);
Project withHandleName(const Project& project, int handle, const std::string& name);

/// Handles that go away together: removed as if never there while nothing has moved (or if they never acted),
/// else let go of at the end; those that were let go of before, as if never there.
Project withoutHandles(const Project& project, const std::vector<int>& handles);

/// A drag of several handles along one path of offsets, the first zero: a Recorded motion at constant speed
/// in a new window of length 1 at the end. `starts` is where each handle is at the gesture's start.
template <int Dim = 2>
Project withStroke(const Project& project, const std::vector<int>& handles,
                   const std::vector<Vec<Dim>>& starts, const std::vector<Vec<Dim>>& offsets);
/// Puts another offset at the end of the last motion of the handles, which withStroke() made.
template <int Dim = 2>
Project withLongerStroke(const Project& project, const std::vector<int>& handles, const Vec<Dim>& step);
/// A gesture of any kind along a path of amounts, the first zero: a stroke if it moves; one motion per piece
/// of the way if it turns or grows, all in a new window of length 1.
template <int Dim>
Project withGesture(const Project& project, const std::vector<int>& handles,
                    const std::vector<Vec<Dim>>& starts, const Grip& grip, const std::vector<Amount>& path);

/// The points that are needed for a polyline within `tolerance` of the given one (Douglas and Peucker); ends
/// are kept, neighbours that coincide are merged.
template <int Dim>
std::vector<Vec<Dim>> simplified(const std::vector<Vec<Dim>>& path, double tolerance);

/// The first time from which two lists of handles prescribe something different; infinity if never. −infinity
/// if the rest shape's constraints themselves differ.
template <int Dim>
double firstDifference(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b);

}  // namespace wend
