#pragma once

#include <memory>
#include <string>
#include <variant>

#include "app/document/project.h"
#include "core/integration/deformer.h"
#include "warp/image.h"

namespace wend {

/// A project with its files read and its mesh made: what the deformer needs.
template <int Dim>
struct Scene {
    std::shared_ptr<const SimplicialMesh<Dim>> rest;
    std::shared_ptr<const Material<Dim>> material;
    std::vector<Handle<Dim>> handles;
    std::shared_ptr<const Image> picture;  // 2D only, may be null
};
using AnyScene = std::variant<Scene<2>, Scene<3>>;

/// Reads the domain's files (paths relative to `folder`), meshes it (points of handles that are there from
/// the start become vertices) and rasterizes the material onto the cells. Throws InputError.
AnyScene loadScene(const Project& project, const std::string& folder);

/// The same steps one by one, for the window: what changes decides what is made again.
std::shared_ptr<const Image> loadPicture(const Project& project, const std::string& folder);
Outline domainOutline(const Domain& domain, const Image& picture);
std::shared_ptr<const SimplicialMesh<2>> meshPicture(const Project& project, const Outline& outline,
                                                     std::stop_token stop = {});
template <int Dim>
std::shared_ptr<const Material<Dim>> rasterizeMaterial(const MaterialSpec<Dim>& spec,
                                                       const SimplicialMesh<Dim>& rest);

}  // namespace wend
