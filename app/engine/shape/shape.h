#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/engine/shape/cage_facts.h"
#include "app/engine/shape/mesh_verdict.h"
#include "core/base/message.h"
#include "core/energy/material.h"
#include "core/mesh/embedding.h"
#include "core/mesh/plane_frame.h"
#include "core/mesh/skin.h"
#include "warp/atlas.h"

namespace wend {

struct MeshFile;

/// p ↦ A p + b: the picture's pixels of a point in the domain's coordinates.
struct PictureMap {
    Mat2 A = Mat2::Identity();
    Vec2 b = Vec2::Zero();

    Points2 operator()(const Points2& points) const { return (A * points).colwise() + b; }
};

/// A part that follows the map of another one and has no mesh in the equations.
struct Rider {
    SimplicialMesh<2> host;  // all points of the shape, and the cells of the part that it is attached to
    Embedding<2> embedding;  // of its points in that
};

/// Placement of a 2D mesh in its picture: of one from a file, or of the parts of a picture in their atlas.
struct Texture {
    std::shared_ptr<const SimplicialMesh<2>> rest;  // what is drawn, in pixels of the picture
    PictureMap toPixels;                            // takes poses to the plane that is rendered
    // The following members are empty for a picture that is one part.
    std::shared_ptr<const SimplicialMesh<2>> drawn = {};  // `rest` in domain coordinates
    std::vector<Sheet> sheets = {};                       // of its parts, in their order
    std::vector<Rider> riders = {};                       // whose vertices come behind those of the shape
    int width = 0, height = 0;                            // of the plane that is rendered

    /// Returns the vertices that are drawn of a pose, in domain coordinates.
    Points2 withRiders(const Points2& pose) const;
    /// Returns how each part is combined with what is below it; nothing if all are normal.
    std::vector<BlendMode> blends() const;
};

/// The shape that is deformed, shown and exported: a domain with its files, mesh and material. Immutable
/// after ShapeBuilder made it, and shared by views and exports.
template <int Dim>
struct Shape {
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const Material<Dim>> material;
    // of a mesh domain the input with its fields and uv, of a surface the generated mesh, of a picture
    // nothing
    std::shared_ptr<const MeshFile> source;
    std::vector<Message> notices;  // messages for the user
    // 2D only.
    std::shared_ptr<const Image> picture;    // may be null
    PlaneFrame plane;                        // of a file's mesh
    std::shared_ptr<const Texture> texture;  // of a file's mesh with a picture; null: coordinates are pixels
    // 3D only.
    std::shared_ptr<const std::vector<Facet<Dim>>> facets;
    std::shared_ptr<const Skin> skin;               // the surface that is shown and exported …
    std::shared_ptr<const Embedding<3>> embedding;  // … and its embedding in the mesh
    /// The points and polylines of `domain.detail`, which are exported in the place of a surface but not
    /// drawn, and their embedding. Null without, and for a detailed surface, which is the skin.
    std::shared_ptr<const Skin> cloud;
    std::shared_ptr<const Embedding<3>> cloudEmbedding;
    std::optional<MeshVerdict> verdict;  // on cells that were made
    std::optional<CageFacts> cage;       // if a cage carries the surface
    bool refineHelps = false;            // splitting the surface's triangles would help
    bool hasSpaces = false;              // shells lie one in the other, or bodies share walls

    /// Returns whether an embedded surface is shown instead of the mesh's vertices.
    bool hidesVertices() const { return embedding && embedding->isFree(); }
    /// Returns what surface formats get, and its embedding.
    const Skin& exported() const { return cloud ? *cloud : *skin; }
    const Embedding<3>& exportedEmbedding() const { return cloud ? *cloudEmbedding : *embedding; }
};
using AnyShape = std::variant<Shape<2>, Shape<3>>;

/// Returns the coordinates of points of space in the shape's rest: for a flat mesh, those in its plane.
template <int Dim>
Points<Dim> ownCoordinates(const Shape<Dim>& shape, const Points3& points) {
    if constexpr (Dim == 2)
        return shape.plane.toPlane(points).template topRows<2>();
    else
        return points;
}
/// Returns where points of space are once their own coordinates are `moved`; the height over a plane stays.
template <int Dim>
Points3 inSpace(const Shape<Dim>& shape, const Points3& points, const Points<Dim>& moved) {
    if constexpr (Dim == 2)
        return shape.plane.moved(points, moved);
    else
        return moved;
}

/// Return the mesh that is drawn: at rest in pixels of the picture, and in a pose in the plane that is
/// rendered. Both are in domain coordinates if there is no picture.
const SimplicialMesh<2>& restInPixels(const Shape<2>& shape);
Points2 inPixels(const Shape<2>& shape, const Points2& pose);

/// Returns the same mesh in domain coordinates: the shape's, followed by the parts that are attached to
/// others.
std::shared_ptr<const SimplicialMesh<2>> drawnRest(const Shape<2>& shape);

/// Returns the rest mesh in the pixels that ST maps refer to: of the picture, or of its parts at rest.
const SimplicialMesh<2>& sourceRest(const Shape<2>& shape);

/// Returns the size of the plane that is rendered, in pixels; the shape must have a picture.
std::array<int, 2> canvasSize(const Shape<2>& shape);

}  // namespace wend
