#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/session/shape/cage_facts.h"
#include "app/session/shape/mesh_verdict.h"
#include "core/energy/material.h"
#include "core/mesh/embedding.h"
#include "core/mesh/skin.h"
#include "warp/image.h"

namespace wend {

struct MeshFile;

/// p ↦ A p + b: the picture's pixels of a point in the domain's coordinates.
struct PictureMap {
    Mat<2> A = Mat<2>::Identity();
    Vec<2> b = Vec<2>::Zero();

    Points<2> operator()(const Points<2>& points) const { return (A * points).colwise() + b; }
};

/// Placement of a 2D mesh from a file in its picture.
struct Texture {
    std::shared_ptr<const SimplicialMesh<2>> rest;  // the rest mesh in pixels of the picture
    PictureMap toPixels;                            // takes poses to the plane that is rendered
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
    std::vector<std::string> notices;  // messages for the user
    // 2D only.
    std::shared_ptr<const Image> picture;    // may be null
    std::shared_ptr<const Texture> texture;  // of a file's mesh with a picture; null: coordinates are pixels
    // 3D only.
    std::shared_ptr<const std::vector<Facet<Dim>>> facets;
    std::shared_ptr<const Skin> skin;               // the surface that is shown and exported …
    std::shared_ptr<const Embedding<3>> embedding;  // … and its embedding in the mesh
    std::optional<MeshVerdict> verdict;             // on cells that were made
    std::optional<CageFacts> cage;                  // if a cage carries the surface
    bool refineHelps = false;                       // splitting the surface's triangles would help

    /// Returns whether an embedded surface is shown instead of the mesh's vertices.
    bool hidesVertices() const { return embedding && embedding->isFree(); }
};
using AnyShape = std::variant<Shape<2>, Shape<3>>;

/// Rest mesh and pose in pixels of the picture, or in domain coordinates if there is none.
const SimplicialMesh<2>& restInPixels(const Shape<2>& shape);
Points<2> inPixels(const Shape<2>& shape, const Points<2>& pose);

}  // namespace wend
