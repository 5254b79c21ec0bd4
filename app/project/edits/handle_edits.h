#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/project/edits/grip.h"
#include "app/project/id.h"
#include "app/project/pin.h"
#include "app/project/project_fwd.h"

class QString;

namespace wend {

class Document;

/// Edits that gestures of the window make: pure functions from a project to the next. Those that take points
/// use the project's dimension.

bool hasMotion(const Design& design);
/// Returns whether a handle moves after a time.
bool movesAfter(const Design& design, double time);
/// Returns the end of the motion: the film's length if something moves, else 0.
double motionEnd(const Project& project);
/// Returns whether a gesture from there would follow all other motion.
bool takesTheEnd(const Project& project, double from);
/// Returns whether the handle acts at time t; one that ends at t does not.
bool isActive(const Pin& handle, double t);
/// Returns the design with a handle that holds from a time on, or from the start if nothing has moved by
/// then.
Design withHandle(const Design& design, Placement<3> at, const std::string& name, double time = 0,
                  const std::string& part = {});
/// Other names for its handles and layers; the same project where none differs.
std::shared_ptr<const Project> withNames(const std::shared_ptr<const Project>& project,
                                         const std::function<std::string(const std::string&)>& nameOf);
/// Returns the design with other points or another name of a handle; its depth regions are renamed, too.
Design withHandlePlace(const Design& design, int handle, Placement<3> at);
Project withHandleName(const Project& project, int handle, const std::string& name);
/// Renames a layer of the depth, and the handle that it belongs to.
Project withDepthName(const Project& project, Id layer, const std::string& wish);
/// Do the same as steps of a document.
void renameHandle(Document& document, const QString& step, int handle, const std::string& name);
void renameDepth(Document& document, const QString& step, Id layer, const std::string& wish);

/// Releases handles at a time, or removes them if they did not act before (or were already released).
Design withoutHandles(const Design& design, const std::vector<int>& handles, double time);

/// The result of a gesture: handles that follow a path of amounts, which starts at zero.
struct Gesture {
    std::vector<int> handles;
    Grip grip = {};
    std::vector<Amount> path;
    double from = 0;                 // when it begins, by the clock of the project that it changes
    double arm = 1;                  // in domain units: lever arm of rotation and scaling
    std::vector<double> times = {};  // of a recording: when it is at each point of the path, the first zero
    std::vector<Amount> curve =
        {};                // of a move that was drawn: the Bézier chain of which the path has points
    bool endsAll = false;  // follows all other motion and removes what was later
};
/// Adds a gesture from a time of the motion; the film keeps its length. If it starts when all motion is over
/// (or ends with it), it is appended, and earlier motions shrink in proportion to their lengths without
/// changing a pose; motions that the user has timed (see hasOwnTiming()) stay, and the film becomes longer
/// by 1. Otherwise it lasts until the end of the film and replaces the later motion of its own handles only.
/// It becomes a Recorded motion if it translates, the curve itself if it was drawn, and one motion per path
/// segment if it rotates or scales. `starts` are the handles' places at its beginning. A recording is added
/// in parallel, too, keeps its duration, and lengthens the film if necessary. The first motion of all gives
/// the film the recording's length.
Project withGesture(const Project& project, const Gesture& gesture, const std::vector<Vec3>& starts);
/// Returns the project with a move at the end of the motion, by offsets of which the first is zero.
Project withStroke(const Project& project, const std::vector<int>& handles, const std::vector<Vec3>& starts,
                   const std::vector<Vec3>& offsets);
/// Puts another offset at the end of the last motion of the handles, which was a move, at the end of the film
/// or since an earlier time.
Project withLongerStroke(const Project& project, const std::vector<int>& handles, const Vec3& step,
                         double arm = 1, bool atTheEnd = true);

/// Returns the points that are needed for a polyline within `tolerance` of the given one (Douglas and
/// Peucker); ends are kept, coincident neighbours are merged.
template <int Size>
std::vector<Vec<Size>> simplified(const std::vector<Vec<Size>>& path, double tolerance);

}  // namespace wend
