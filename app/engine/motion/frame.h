#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

#include "app/project/edits/grip.h"
#include "core/base/message.h"
#include "core/energy/material.h"
#include "core/mesh/point_locator.h"
#include "core/mesh/region.h"

namespace wend {

struct Distortion;

/// A place of a rest shape: a cell and barycentric coordinates, of which the last is 0 in pictures.
using Place = Location<3>;

/// A shape at a time, as the compute thread passes it to session and views: in the coordinates of space, with
/// z = 0 in pictures. Vertices and cells have the numbers of the rest mesh. Immutable and shared.
struct ShapeFrame {
    int generation = 0;  // of the document that it belongs to
    double time = 0;
    bool live = false;  // a preview while dragging; otherwise of final quality
    int dimension = 0;
    std::shared_ptr<const void> shape;      // the rest mesh, to compare shapes by identity
    int vertices = 0, used = 0, cells = 0;  // the vertices that cells have, of all
    double diagonal = 0;                    // size of the rest shape; for a box its diagonal (ShapeSize)
    std::shared_ptr<const Distortion> distortion;
    double growth = 1;        // area or volume relative to rest
    double pinError = 0;      // largest distance of a pin from where it should be, in the domain's units
    double milliseconds = 0;  // that this frame took; 0 if it came from a longer run
    int gesture = 0;          // live: the number of the drag
    int sample = -1;          // live: the newest sample of the drag that it follows
    Amount amount = Amount::Zero();  // live: offset that the dragged handles have reached
    bool stopped = false;            // live: the handles could not reach the sample without a fold
    Message message;                 // why not

    virtual ~ShapeFrame() = default;
    virtual Vec3 vertex(int v) const = 0;
    virtual Vec3 restVertex(int v) const = 0;
    virtual std::span<const int> corners(int cell) const = 0;
    /// Returns the area or volume of a cell at rest.
    virtual double restMeasure(int cell) const = 0;
    /// Returns whether an embedded surface is shown instead of the mesh's vertices.
    virtual bool hidesVertices() const = 0;
    /// Returns the parts of a picture's mesh from back to front; none if it has one without a name.
    virtual const std::vector<MeshPart>& parts() const = 0;
    /// Returns the place of a point of the pose; of several, the one in the cell of highest index.
    virtual std::optional<Place> find(const Vec3& p) const = 0;
    /// Returns the barycentric coordinates of a point of the pose in a cell.
    virtual Place placeIn(int cell, const Vec3& p) const = 0;
    /// Returns the rotation of a cell from rest to the pose: the polar factor of its deformation gradient.
    virtual Mat3 rotationOf(int cell) const = 0;
    /// Map a point of a part, or of the whole shape if none is named, from rest to the pose and back; outside
    /// by the offset from the nearest vertex.
    virtual Vec3 carriedFromRest(const Vec3& p, const std::string& part) const = 0;
    virtual Vec3 carriedToRest(const Vec3& p, const std::string& part) const = 0;
    /// Returns the vertices of the rest shape inside the region, in increasing order.
    virtual std::vector<int> verticesInside(const Region<3>& region) const = 0;

    /// Return the point at a place, in the pose and at rest: Σ weight · x_corner.
    Vec3 at(const Place& place) const;
    Vec3 restAt(const Place& place) const;
    /// Returns the middle of a cell in the pose.
    Vec3 centreOf(int cell) const;
    /// Returns the middle of the pose's bounding box.
    Vec3 middle() const;
    /// Returns the name of the part that a cell belongs to; empty if there are no parts.
    std::string partOf(int cell) const;
};
/// How much of the existing frames stays valid after a change: their times are multiplied by the scale, then
/// those up to a time are kept (−∞: none).
struct KeptFrames {
    double timeScale = 1;
    double upTo = 0;
};
using FramePtr = std::shared_ptr<const ShapeFrame>;
/// Velocities, one column per vertex, in domain units per unit of time.
using VelocityPtr = std::shared_ptr<const Eigen::MatrixXd>;

template <int Dim>
struct Shape;

/// The shape itself.
template <int Dim>
struct PosedFrame : ShapeFrame {
    std::shared_ptr<const Shape<Dim>> built;  // the built shape with its file, picture and skin
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const Material<Dim>> material;
    Points<Dim> pose;

    PosedFrame() { dimension = Dim; }
    Vec3 vertex(int v) const override { return inSpace(Vec<Dim>(pose.col(v))); }
    Vec3 restVertex(int v) const override { return inSpace(Vec<Dim>(rest->points.col(v))); }
    std::span<const int> corners(int cell) const override { return rest->cells[cell]; }
    double restMeasure(int cell) const override {
        return std::abs(cellMeasure<Dim>(rest->points, rest->cells[cell]));
    }
    bool hidesVertices() const override;
    const std::vector<MeshPart>& parts() const override { return rest->parts; }
    std::optional<Place> find(const Vec3& p) const override;
    Place placeIn(int cell, const Vec3& p) const override;
    Mat3 rotationOf(int cell) const override;
    Vec3 carriedFromRest(const Vec3& p, const std::string& part) const override;
    Vec3 carriedToRest(const Vec3& p, const std::string& part) const override;
    std::vector<int> verticesInside(const Region<3>& region) const override;
};
extern template struct PosedFrame<2>;
extern template struct PosedFrame<3>;
template <int Dim>
using PosedPtr = std::shared_ptr<const PosedFrame<Dim>>;

/// Returns a place in the coordinates of space.
template <int Dim>
Place inSpace(const Location<Dim>& location) {
    Place place{location.cell, Eigen::Vector4d::Zero()};
    place.weights.template head<Dim + 1>() = location.weights;
    return place;
}

/// Returns the point at a location of a mesh, in one of its forms: Σ weight · x_corner.
template <int Dim>
Vec<Dim> positionOf(const Location<Dim>& location, const SimplicialMesh<Dim>& mesh, const Points<Dim>& form) {
    Vec<Dim> p = Vec<Dim>::Zero();
    for (int k = 0; k <= Dim; ++k) p += location.weights[k] * form.col(mesh.cells[location.cell][k]);
    return p;
}

/// Casts the frame; returns null if there is none or if its dimension differs.
template <int Dim>
PosedPtr<Dim> posed(const FramePtr& frame) {
    if (!frame || frame->dimension != Dim) return {};
    return std::static_pointer_cast<const PosedFrame<Dim>>(frame);
}

/// Returns the frame with another time and the same shape.
FramePtr atTime(const FramePtr& frame, double time);
/// Returns the frame with its shape at rest.
FramePtr atRest(const FramePtr& frame);

}  // namespace wend
