#include "app/session/scene.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>

#include "app/session/caged_solid.h"
#include "app/session/held_border.h"
#include "app/session/mesh_rest.h"
#include "app/session/solid.h"
#include "core/mesh/error.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/segments.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/planar_mesher.h"
#include "warp/outline.h"

namespace wend {
namespace {

constexpr double kCoincident = 1e-9;  // of the diagonal: the mesher's own measure

// --- Pictures ---

double outlineDiagonal(const Outline& outline) {
    Eigen::AlignedBox2d box;
    for (const auto& loop : outline.loops)
        for (const Vec<2>& point : loop) box.extend(point);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// Whether the mesher takes the point: inside by even and odd, or on the border within the tolerance.
bool belongs(const Outline& outline, const Vec<2>& p, double tolerance) {
    bool inside = false;
    for (const auto& loop : outline.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec<2>&a = loop[i], &b = loop[(i + 1) % loop.size()];
            if (distanceToSegment<2>(p, a, b) <= tolerance) return true;
            if (crossesRay(a, b, p)) inside = !inside;
        }
    return inside;
}

/// Where handles sit that are there from the start, each place once. Points outside are left to the deformer,
/// which names their handle.
std::vector<Vec<2>> handlePoints(const Project& project, const Outline& outline) {
    const double tolerance = kCoincident * outlineDiagonal(outline);
    std::vector<Vec<2>> points;
    for (const Handle<2>& handle : std::get<Design<2>>(project.design).handles) {
        const auto* places = std::get_if<std::vector<Vec<2>>>(&handle.at);
        if (!places || handle.activeFrom > 0) continue;
        for (const Vec<2>& place : *places) {
            const bool known = std::ranges::any_of(
                points, [&](const Vec<2>& p) { return (p - place).norm() <= 2 * tolerance; });
            if (!known && belongs(outline, place, tolerance)) points.push_back(place);
        }
    }
    return points;
}

/// With an alpha outline the mesh may be as coarse as asked for at the cost of some of the margin.
double outlineSlack(const Domain& domain) {
    return domain.outline == OutlineKind::Alpha ? std::max(0.0, domain.alpha.margin - domain.alpha.simplify)
                                                : 0;
}

Scene<2> imageScene(const Project& project, const std::string& folder, std::stop_token stop) {
    const std::string path = pathIn(folder, project.domain.path);
    Scene<2> scene;
    scene.picture = loadPicture(project, folder);
    try {
        scene.rest = meshPicture(project, domainOutline(project.domain, *scene.picture), stop);
    } catch (const InputError& error) {
        // Polygons stand in the project, whose file the caller names.
        if (project.domain.outline == OutlineKind::Polygons)
            throw InputError("domain.outline.polygons: " + error.reason());
        throw error.named(path);
    }
    tellOfHanging<2>(*scene.rest, scene.notices);
    scene.texture = textureOf(scene.picture, scene.rest, {});
    return scene;
}

// --- Meshes and solids ---

Scene<2> planarMeshScene(const Project& project, const std::string& folder) {
    const std::string path = pathIn(folder, project.domain.path);
    Scene<2> scene;
    auto file = std::make_shared<MeshFile>(readMeshFile(path));
    std::shared_ptr<const SimplicialMesh<2>> textured;
    if (isVolume(*file)) throw InputError(path, "holds tetrahedra, but the project is in the plane");
    try {
        textured = std::make_shared<const SimplicialMesh<2>>(meshFrom<2>(*file));
        scene.rest = joinedRest<2>(*textured, scene.notices);
    } catch (const InputError& error) {
        throw error.named(path);
    }
    scene.source = file;
    tellOfHanging<2>(*scene.rest, scene.notices);
    scene.picture = loadPicture(project, folder);
    // On the file's own cells: at a seam, vertices at one place have texture points of their own.
    if (scene.picture) scene.texture = textureOf(scene.picture, textured, scene.source->uv);
    return scene;
}

Scene<3> solidScene(const Project& project, const std::string& folder, std::stop_token stop) {
    Solid solid = loadSolid(project, folder, stop);
    Scene<3> scene;
    scene.rest = std::move(solid.rest);
    scene.source = std::move(solid.source);
    scene.skin = std::move(solid.skin);
    scene.embedding = std::move(solid.embedding);
    scene.verdict = solid.verdict;
    scene.cage = solid.cage;
    scene.notices = std::move(solid.notices);
    return scene;
}

/// Vertices by number are the surface's: in a cage, where those have none, they are the points at their
/// places.
std::vector<Handle<3>> handlesOn(const Scene<3>& scene, std::vector<Handle<3>> handles) {
    if (!scene.cage) return handles;
    for (Handle<3>& handle : handles)
        if (const auto* vertices = std::get_if<std::vector<int>>(&handle.at))
            handle.at = placesOf(*vertices, *scene.skin);
    return handles;
}
std::vector<Handle<2>> handlesOn(const Scene<2>&, std::vector<Handle<2>> handles) {
    return handles;
}

template <int Dim>
AnyScene furnished(Scene<Dim> scene, const Project& project, const std::string& folder) {
    const auto& design = std::get<Design<Dim>>(project.design);
    scene.material = rasterizeMaterial<Dim>(design.material, *scene.rest, folder);
    const bool framed = project.domain.kind == DomainKind::Image && scene.picture;
    const Vec<2> frame = framed ? Vec<2>(scene.picture->width, scene.picture->height) : Vec<2>(0, 0);
    scene.handles = handlesOn(scene, heldHandles<Dim>(project, *scene.rest, frame));
    return scene;
}

}  // namespace

std::shared_ptr<const Image> loadPicture(const Project& project, const std::string& folder) {
    const Domain& domain = project.domain;
    const std::string& file = domain.kind == DomainKind::Image ? domain.path : domain.texture;
    if (file.empty() || domain.kind == DomainKind::Surface || project.dimension() == 3) return nullptr;
    return std::make_shared<const Image>(readImage(pathIn(folder, file)));
}

Outline domainOutline(const Domain& domain, const Image& picture) {
    if (domain.outline == OutlineKind::Polygons) return domain.polygons;
    if (domain.outline == OutlineKind::Alpha) return outlineFromAlpha(picture, domain.alpha);
    return frameOutline(picture.width, picture.height);
}

std::shared_ptr<const SimplicialMesh<2>> meshPicture(const Project& project, const Outline& outline,
                                                     std::stop_token stop) {
    PlanarMeshOptions options;
    options.vertices = project.domain.vertices;
    options.edge = project.domain.edge;
    options.simplify = outlineSlack(project.domain);
    options.points = handlePoints(project, outline);
    if (!project.domain.flatSizes.empty())
        options.factor = [&sizes = project.domain.flatSizes](const Vec<2>& p) {
            double factor = 1;
            for (const SizeRegionIn<2>& region : sizes)
                factor += membership<2>(region.shape, p, region.feather) * (region.factor - factor);
            return factor;
        };
    options.stop = stop;
    return std::make_shared<const SimplicialMesh<2>>(meshOutline(outline, options));
}

int restMarginOf(const Domain& domain) {
    if (domain.kind != DomainKind::Image || domain.outline != OutlineKind::Alpha) return 0;
    return static_cast<int>(std::ceil(domain.alpha.margin + domain.alpha.gap)) + 1;
}

Texture textureOf(std::shared_ptr<const Image> picture, std::shared_ptr<const SimplicialMesh<2>> rest,
                  const Eigen::Matrix2Xd& uv) {
    Texture texture{picture, rest, {}};
    if (uv.cols() != rest->points.cols() || uv.cols() == 0) return texture;
    SimplicialMesh<2> pixels = *rest;
    pixels.points.row(0) = picture->width * uv.row(0);
    pixels.points.row(1) = picture->height * (1 - uv.row(1).array());
    // Least squares for pixels = [A b] [p; 1], over the vertices that cells have.
    const std::vector<bool> used = usedVertices<2>(rest->vertexCount(), rest->cells);
    std::vector<int> rows;
    for (int v = 0; v < rest->vertexCount(); ++v)
        if (used[v]) rows.push_back(v);
    const Eigen::MatrixX3d ones = rest->points(Eigen::all, rows).transpose().rowwise().homogeneous();
    const Eigen::MatrixX2d targets = pixels.points(Eigen::all, rows).transpose();
    const Eigen::Matrix<double, 3, 2> fit = ones.colPivHouseholderQr().solve(targets);
    texture.toPixels = {fit.topRows<2>().transpose(), fit.row(2).transpose()};
    texture.rest = std::make_shared<const SimplicialMesh<2>>(std::move(pixels));
    return texture;
}

AnyScene loadScene(const Project& project, const std::string& folder, std::stop_token stop) {
    if (project.dimension() == 3) return furnished(solidScene(project, folder, stop), project, folder);
    if (project.domain.kind == DomainKind::Image)
        return furnished(imageScene(project, folder, stop), project, folder);
    return furnished(planarMeshScene(project, folder), project, folder);
}

}  // namespace wend
