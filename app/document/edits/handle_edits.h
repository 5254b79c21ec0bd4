#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/document/edits/grip.h"
#include "app/document/project_fwd.h"
#include "core/motion/handle.h"

class QString;

namespace wend {

class Document;

/// What the gestures of the window make of a project: pure functions from a project to the next one. Those
/// that take points are of the project's own dimension.

template <int Dim>
bool hasMotion(const Design<Dim>& design);
/// True if some handle moves after a time.
template <int Dim>
bool movesAfter(const Design<Dim>& design, double time);
/// When the motion is over: the length of the film once something moves, 0 before.
double motionEnd(const Project& project);
/// True if a gesture from there comes after all that moves.
bool takesTheEnd(const Project& project, double from);
/// True if the handle holds the shape at time t; one that ends at t is gone.
template <int Dim>
bool isActive(const Handle<Dim>& handle, double t);
/// A handle that holds from a time on; from the start if nothing has moved by then.
template <int Dim>
Design<Dim> withHandle(const Design<Dim>& design, Placement<Dim> at, const std::string& name,
                       double time = 0);
/// Other names for its handles and layers; the same project where none differs.
std::shared_ptr<const Project> withNames(const std::shared_ptr<const Project>& project,
                                         const std::function<std::string(const std::string&)>& nameOf);
/// Other points to hold, or another name, which what it brings to the front or back has too.
template <int Dim>
Design<Dim> withHandlePlace(const Design<Dim>& design, int handle, Placement<Dim> at);
Project withHandleName(const Project& project, int handle, const std::string& name);
/// Another name for a group of namedRegions() of the depth, and for the handle that gives it.
Project withDepthName(const Project& project, int group, const std::string& wish);
/// The same as steps of a document.
void renameHandle(Document& document, const QString& step, int handle, const std::string& name);
void renameDepth(Document& document, const QString& step, int group, const std::string& wish);

/// Handles that go away at a time: let go of then, or removed as if never there if they did not act before
/// (or were let go of already).
AnyDesign withoutHandles(const AnyDesign& design, const std::vector<int>& handles, double time);

/// What is made of a gesture: handles go along a path of amounts, the first zero.
struct Gesture {
    std::vector<int> handles;
    Grip grip = {};
    std::vector<Amount> path;
    double from = 0;                 // when it begins, by the clock of the project that it changes
    double arm = 1;                  // in the domain's units: where turning and growing count as a way
    std::vector<double> times = {};  // of a recording: when it is at each point of the path, the first zero
    std::vector<Amount> curve =
        {};                // of a move that was drawn: the Bézier chain of which the path has points
    bool endsAll = false;  // it comes after all that moves, and what was later goes
};
/// A gesture goes on from a time of the motion; the film keeps its length. Where all motion is over (or ends
/// with it) the gesture takes its place at the end, and what lies before moves together, each in proportion
/// to its way: no pose on the way changes. Earlier it lasts until the end of the film and replaces what its
/// own handles did from then on; what others do stays. It becomes a Recorded motion if it moves, the curve if
/// it was drawn, and one motion per piece of the way if it turns or grows. `starts` is where each handle is
/// at its beginning. A recording stands beside the others, too, and lasts as long as it took; the film
/// becomes longer where it must. The first motion of all makes the film as long as a recording.
template <int Dim>
Project withGesture(const Project& project, const Gesture& gesture, const std::vector<Vec<Dim>>& starts);
/// A move at the end of the motion, by offsets of which the first is zero.
template <int Dim = 2>
Project withStroke(const Project& project, const std::vector<int>& handles,
                   const std::vector<Vec<Dim>>& starts, const std::vector<Vec<Dim>>& offsets);
/// Puts another offset at the end of the last motion of the handles, which was a move, at the end of the film
/// or since an earlier time.
template <int Dim = 2>
Project withLongerStroke(const Project& project, const std::vector<int>& handles, const Vec<Dim>& step,
                         double arm = 1, bool atTheEnd = true);

/// The points that are needed for a polyline within `tolerance` of the given one (Douglas and Peucker); ends
/// are kept, neighbours that coincide are merged.
template <int Dim>
std::vector<Vec<Dim>> simplified(const std::vector<Vec<Dim>>& path, double tolerance);

}  // namespace wend
