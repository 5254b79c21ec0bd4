#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>

#include "app/document/project.h"
#include "app/session/cage_facts.h"
#include "app/session/mesh_verdict.h"
#include "core/integration/deformer.h"
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

/// A picture on a mesh in the plane.
struct Texture {
    std::shared_ptr<const Image> picture;
    std::shared_ptr<const SimplicialMesh<2>> rest;  // the rest mesh in pixels of the picture
    PictureMap toPixels;                            // takes poses to the plane that is rendered
};

/// A project with its files read and its mesh made: what the deformer needs.
template <int Dim>
struct Scene {
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const Material<Dim>> material;
    std::vector<Handle<Dim>> handles;
    std::shared_ptr<const Image> picture;    // 2D only, may be null
    std::shared_ptr<const MeshFile> source;  // of a mesh domain what came in, with its fields and uv; of a
                                             // surface what was made
    Texture texture;                         // 2D only; empty without a picture
    std::shared_ptr<const Skin> skin;        // 3D only: the surface that is seen and exported …
    std::shared_ptr<const Embedding<3>> embedding;  // … and what takes its points along
    std::optional<MeshVerdict> verdict;             // 3D only: on cells that were made
    std::optional<CageFacts> cage;                  // 3D only: if a cage carries the surface
    std::vector<std::string> notices;               // what the user should hear
};
using AnyScene = std::variant<Scene<2>, Scene<3>>;

/// Reads the domain's files (paths relative to `folder`), meshes it (points of handles that are there from
/// the start become vertices) and rasterizes the material onto the cells. Throws InputError, and Cancelled
/// when stopped.
AnyScene loadScene(const Project& project, const std::string& folder, std::stop_token stop = {});

/// The same steps one by one, for the window: what changes decides what is made again.
/// The picture of the domain, or null if it has none.
std::shared_ptr<const Image> loadPicture(const Project& project, const std::string& folder);
Outline domainOutline(const Domain& domain, const Image& picture);
std::shared_ptr<const SimplicialMesh<2>> meshPicture(const Project& project, const Outline& outline,
                                                     std::stop_token stop = {});

/// φ and B of every cell, taken at its centroid. On the cells' own values, if the spec has them, each region
/// in turn lays its φ and B with its membership m: φ + m (φ_region − φ) and (1 − m) B + m B_region, which
/// stays symmetric positive definite. A file with the cells' values is read from `folder`. Throws InputError
/// that names the key.
template <int Dim>
std::shared_ptr<const Material<Dim>> rasterizeMaterial(const MaterialSpec<Dim>& spec,
                                                       const SimplicialMesh<Dim>& rest,
                                                       const std::string& folder = {});

/// WarpOptions::restMargin for the domain's outline: what growing it reaches, if it follows alpha.
int restMarginOf(const Domain& domain);

/// Where the rest mesh lies in the picture: with uv (one per vertex, origin at the bottom left) by them, and
/// poses through the affine map that fits them best; without uv, coordinates are pixels.
Texture textureOf(std::shared_ptr<const Image> picture, std::shared_ptr<const SimplicialMesh<2>> rest,
                  const Eigen::Matrix2Xd& uv);

}  // namespace wend
