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

/// Where a file's mesh in the plane lies in its picture.
struct Texture {
    std::shared_ptr<const SimplicialMesh<2>> rest;  // the rest mesh in pixels of the picture
    PictureMap toPixels;                            // takes poses to the plane that is rendered
};

/// What is bent, seen and exported: a domain with its files read, its mesh made and the material laid on it.
/// Immutable once it is built (ShapeBuilder), and shared from there to the screen and to the files.
template <int Dim>
struct Shape {
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const Material<Dim>> material;
    std::shared_ptr<const MeshFile> source;  // of a mesh domain what came in, with its fields and uv; of a
                                             // surface what was made; of a picture nothing
    std::vector<std::string> notices;        // what the user should hear
    // In the plane.
    std::shared_ptr<const Image> picture;    // may be null
    std::shared_ptr<const Texture> texture;  // of a file's mesh with a picture; null: coordinates are pixels
    // In space.
    std::shared_ptr<const std::vector<Facet<Dim>>> facets;
    std::shared_ptr<const Skin> skin;               // the surface that is seen and exported …
    std::shared_ptr<const Embedding<3>> embedding;  // … and what takes its points along
    std::optional<MeshVerdict> verdict;             // on cells that were made
    std::optional<CageFacts> cage;                  // if a cage carries the surface
    bool refineHelps = false;                       // splitting the surface's triangles would help

    /// Whether a surface with points of its own is seen, and the vertices of the mesh are not.
    bool hidesVertices() const { return embedding && embedding->isFree(); }
};
using AnyShape = std::variant<Shape<2>, Shape<3>>;

/// The rest mesh and a pose in pixels of the picture, or in the domain's coordinates if there is none.
const SimplicialMesh<2>& restInPixels(const Shape<2>& shape);
Points<2> inPixels(const Shape<2>& shape, const Points<2>& pose);

}  // namespace wend
