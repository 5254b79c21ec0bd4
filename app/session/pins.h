#pragma once

#include <QString>
#include <vector>

#include "app/engine/motion/places.h"
#include "app/project/edits/document.h"

namespace wend {

class ShapeMotion;

/// The place of a handle in a pose.
struct PinView {
    int handle = -1;
    QString name;
    bool region = false;
    std::vector<Vec3> points;
    std::vector<Place> places;  // of the points
    Vec3 centre = Vec3::Zero();
};

/// Returns the handles that hold the shape at `time`, in the pose of a frame, or those that do not.
std::vector<PinView> viewPins(const std::vector<Pin>& handles, const std::vector<PinPlace>& places,
                              const ShapeFrame& frame, double time, bool holding = true);

/// Requires at least one point.
Vec3 meanOf(const std::vector<Vec3>& points);

/// Returns the corners of the convex hull, in order.
std::vector<Vec2> convexHull(std::vector<Vec2> points);

/// The path of a handle's point from where it begins, sampled for drawing, with the times of the samples.
struct PinPath {
    std::vector<Vec3> points;
    std::vector<double> times;
};
/// `dimension`: of the shape, because the frames of a curve in the plane are not those of one in space.
std::vector<PinPath> pinPaths(const Pin& handle, const std::vector<Vec3>& starts, int dimension);

/// The document's handles in the shown frame. Their places in the rest mesh are cached per project and mesh.
/// Lives in the window's thread.
class ShownPins {
  public:
    ShownPins(const Document& document, const ShapeMotion& motion) : m_document(document), m_motion(motion) {}

    int count() const;
    /// Returns whether a handle may not be changed: it is locked, or the part that it is in.
    bool isLocked(int handle) const;
    /// Returns the name of a single handle, or else their number.
    QString nameOf(const std::vector<int>& handles) const;
    /// Returns the pins that act at a time, or those that do not; hidden ones only if `all`.
    std::vector<PinView> at(double time, bool holding, bool all) const;
    std::vector<Vec3> pathStarts(int handle) const;
    /// Returns the vertices that a handle of a solid holds, in increasing order.
    std::vector<int> verticesOf(int handle) const;
    Placement<3> placementOf(const std::vector<int>& vertices) const;
    /// Resets the cache for another file.
    void drop() { m_places = {}; }

  private:
    FramePtr shape() const;
    const std::vector<PinPlace>& places() const;

    const Document& m_document;
    const ShapeMotion& m_motion;
    struct Cache {
        std::shared_ptr<const void> rest;
        std::shared_ptr<const Project> project;
        std::vector<PinPlace> of;
    };
    mutable Cache m_places;
};

}  // namespace wend
