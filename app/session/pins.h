#pragma once

#include <QString>
#include <vector>

#include "app/engine/motion/rest_places.h"

namespace wend {

/// The place of a handle in a pose.
struct PinView {
    int handle = -1;
    QString name;
    bool region = false;
    std::vector<Vec3> points;
    std::vector<Place> places;  // of the points
    Vec3 centre = Vec3::Zero();
};

/// The handles that hold the shape at `time`, in the pose of a frame; or those that do not.
std::vector<PinView> viewPins(const std::vector<Pin>& handles, const std::vector<PinPlace>& places,
                              const ShapeFrame& frame, double time, bool holding = true);

/// Requires at least one point.
Vec3 meanOf(const std::vector<Vec3>& points);

/// Returns the corners of the convex hull, in order.
std::vector<Vec<2>> convexHull(std::vector<Vec<2>> points);

/// The path of a handle's point from where it begins, sampled for drawing, with the times of the samples.
struct PinPath {
    std::vector<Vec3> points;
    std::vector<double> times;
};
/// `dimension`: of the shape, because the frames of a curve in the plane are not those of one in space.
std::vector<PinPath> pinPaths(const Pin& handle, const std::vector<Vec3>& starts, int dimension);

}  // namespace wend
