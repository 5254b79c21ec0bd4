#pragma once

#include <QString>
#include <vector>

#include "app/engine/motion/frame.h"
#include "core/mesh/point_locator.h"
#include "core/motion/handle.h"

namespace wend {

/// The place of a handle in the rest mesh.
template <int Dim>
struct PinPlace {
    std::vector<Location<Dim>> points;  // for vertices and points
    bool region = false;                // many vertices: shown as one pin at their centre

    bool isEmpty() const { return points.empty(); }
};

/// The place of a handle in a pose.
template <int Dim>
struct PinView {
    int handle = -1;
    QString name;
    bool region = false;
    std::vector<Vec<Dim>> points;
    std::vector<Location<Dim>> places;  // of the points
    Vec<Dim> centre = Vec<Dim>::Zero();
};

/// Returns the places of all handles in a rest mesh; empty for handles outside it.
template <int Dim>
std::vector<PinPlace<Dim>> placePins(const std::vector<Pin>& handles, const SimplicialMesh<Dim>& rest,
                                     const PointLocator<Dim>& locator);

template <int Dim>
Vec<Dim> positionOf(const Location<Dim>& location, const SimplicialMesh<Dim>& rest, const Points<Dim>& pose);

/// The handles that hold the shape at `time`, in the given pose; or those that do not.
template <int Dim>
std::vector<PinView<Dim>> viewPins(const std::vector<Pin>& handles, const std::vector<PinPlace<Dim>>& places,
                                   const SimplicialMesh<Dim>& rest, const Points<Dim>& pose, double time,
                                   bool holding = true);

template <int Dim>
Vec<Dim> meanOf(const std::vector<Vec<Dim>>& points);

/// Returns the corners of the convex hull, in order.
std::vector<Vec<2>> convexHull(std::vector<Vec<2>> points);

/// The path of a handle's point from where it begins, sampled for drawing, with the times of the samples.
template <int Dim>
struct PinPath {
    std::vector<Vec<Dim>> points;
    std::vector<double> times;
};
template <int Dim>
std::vector<PinPath<Dim>> pinPaths(const Pin& handle, const std::vector<Vec<Dim>>& starts);

}  // namespace wend
