#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/engine/motion/frame.h"
#include "core/mesh/point_locator.h"
#include "core/mesh/region.h"

namespace wend {

/// Returns the barycentric coordinates of a point in a cell of a pose.
template <int Dim>
Location<Dim> locationIn(const PosedFrame<Dim>& frame, int cell, const Vec<Dim>& p);
/// Returns the rotation of a cell from rest to the pose: the polar factor of its deformation gradient.
template <int Dim>
Mat<Dim> cellRotation(const PosedFrame<Dim>& frame, int cell);

/// Returns the vertices of the rest mesh inside the region, in increasing order.
template <int Dim>
std::vector<int> verticesInside(const Region<Dim>& region, const SimplicialMesh<Dim>& rest);

/// x ↦ A x + b.
template <int Dim>
struct CarryingOf {
    Mat<Dim> A = Mat<Dim>::Identity();
    Vec<Dim> b = Vec<Dim>::Zero();

    Vec<Dim> operator()(const Vec<Dim>& x) const { return A * x + b; }
};
/// Fits the affine map from rest to pose by least squares; a translation if the points are too few or
/// coplanar (collinear in the plane). Exact for points that moved as one.
template <int Dim>
CarryingOf<Dim> carryingBetween(const std::vector<Vec<Dim>>& rest, const std::vector<Vec<Dim>>& posed);
/// Fits that map to vertices of a frame.
CarryingOf<3> carryingOf(const PosedFrame<3>& frame, const std::vector<int>& vertices);

/// Size of a solid, or of the part with the given vertices: the volume of its cells and the area of the
/// boundary triangles whose vertices all belong to it.
struct SolidSize {
    double volume = 0, area = 0;
};
SolidSize sizeOf(const PosedFrame<3>& frame, const Points3& points);
SolidSize sizeOf(const PosedFrame<3>& frame, const Points3& points, const std::vector<int>& vertices);

/// The places that a handle holds; none if it is outside the shape.
struct PinPlace {
    std::vector<Place> points;  // for vertices and points
    bool region = false;        // many vertices: shown as one pin at their centre

    bool isEmpty() const { return points.empty(); }
};

/// Finds places in the rest shape of a frame, which must outlive it.
class RestPlaces {
  public:
    static std::unique_ptr<const RestPlaces> of(const ShapeFrame& frame);
    virtual ~RestPlaces() = default;

    /// Returns the place of a point at rest, on the boundary within 1e-9 of a cell's size.
    virtual std::optional<Place> find(const Vec3& p) const = 0;
    /// Returns the nearest vertex of a cell, the lowest of several.
    virtual int nearestVertex(const Vec3& p) const = 0;
    /// Returns the places of a handle's points, in the part that it names or in the frontmost one that has
    /// them.
    virtual PinPlace placeOf(const Pin& pin) const = 0;
    std::vector<PinPlace> placesOf(const std::vector<Pin>& pins) const;
};

}  // namespace wend
