#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/session/frame.h"
#include "core/mesh/point_locator.h"
#include "core/motion/handle.h"

namespace wend {

/// Where a handle takes hold of the rest mesh.
struct PinPlace {
    std::vector<Location<2>> points;  // for vertices and points
    bool region = false;              // many vertices: shown as one pin at their centre

    bool isEmpty() const { return points.empty(); }
};

/// Where a handle is in a pose.
struct PinView {
    int handle = -1;
    QString name;
    bool region = false;
    std::vector<Vec<2>> points;
    Vec<2> centre = Vec<2>::Zero();
};

/// The places of all handles in a rest mesh; empty for one that lies outside.
std::vector<PinPlace> placePins(const std::vector<Handle<2>>& handles, const SimplicialMesh<2>& rest,
                                const PointLocator<2>& locator);

Vec<2> positionOf(const Location<2>& location, const SimplicialMesh<2>& rest, const Points<2>& pose);

/// The handles that hold the shape at `time`, in the given pose.
std::vector<PinView> viewPins(const std::vector<Handle<2>>& handles, const std::vector<PinPlace>& places,
                              const SimplicialMesh<2>& rest, const Points<2>& pose, double time);

/// The corners of the convex hull, in order.
std::vector<Vec<2>> convexHull(std::vector<Vec<2>> points);

/// The rest point under a point of the pose; of several where the shape lies over itself, the one on top.
std::optional<Vec<2>> restPoint(const SimplicialMesh<2>& rest, const Points<2>& pose, const Vec<2>& p);

/// The path of a handle's point from where it begins, sampled for drawing, with the times of the samples.
struct PinPath {
    std::vector<Vec<2>> points;
    std::vector<double> times;
};
std::vector<PinPath> pinPaths(const Handle<2>& handle, const std::vector<Vec<2>>& starts);

}  // namespace wend
