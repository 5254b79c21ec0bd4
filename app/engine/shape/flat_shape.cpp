#include "app/engine/shape/flat_shape.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "app/engine/shape/mesh_rest.h"
#include "app/engine/shape/part_pictures.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "core/base/error.h"
#include "core/mesh/decompositions.h"
#include "core/mesh/file_cells.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/segments.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/planar_mesher.h"
#include "warp/drawn_picture.h"
#include "warp/outline.h"

namespace wend {
namespace {

constexpr double kCoincident = 1e-9;  // of the diagonal: the mesher's own measure
constexpr double kPromised = 1.15;    // times the vertices that are aimed at

double outlineDiagonal(const Outline& outline) {
    Eigen::AlignedBox2d box;
    for (const auto& loop : outline.loops)
        for (const Vec2& point : loop) box.extend(point);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// Returns whether the mesher takes the point: inside by the even-odd rule, or on the border within the
/// tolerance.
bool belongs(const Outline& outline, const Vec2& p, double tolerance) {
    bool inside = false;
    for (const auto& loop : outline.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            if (distanceToSegment<2>(p, a, b) <= tolerance) return true;
            if (crossesRay(a, b, p)) inside = !inside;
        }
    return inside;
}

/// Returns the places of handles that are there from the start, each place once. Points outside are left to
/// the deformer, which names their handle.
std::vector<Vec2> handlePoints(const Design& design, const Outline& outline) {
    const double tolerance = kCoincident * outlineDiagonal(outline);
    std::vector<Vec2> points;
    for (const Pin& handle : design.handles) {
        const auto* places = std::get_if<std::vector<Vec3>>(&handle.at);
        if (!places || handle.activeFrom > 0) continue;
        for (const Vec3& at : *places) {
            const Vec2 place = inPlane(at);
            const bool known = std::ranges::any_of(
                points, [&](const Vec2& p) { return (p - place).norm() <= 2 * tolerance; });
            if (!known && belongs(outline, place, tolerance)) points.push_back(place);
        }
    }
    return points;
}

/// Returns how much of the margin may be given up, so that the mesh with an alpha outline is as coarse as
/// requested.
double outlineSlack(const Domain& domain) {
    return domain.outline == OutlineKind::Alpha ? std::max(0.0, domain.alpha.margin - domain.alpha.simplify)
                                                : 0;
}

}  // namespace

bool isInOutline(const Outline& outline, const Vec2& p) {
    return belongs(outline, p, kCoincident * outlineDiagonal(outline));
}

std::shared_ptr<const Image> loadPicture(const Domain& domain, const std::string& folder,
                                         std::vector<Message>* notices) {
    if (!domain.parts.empty()) {
        const PartPictures pictures = loadParts(atRest(domain.parts), folder, {}, notices, domain.size);
        return std::make_shared<const Image>(flattened(pictures.sheets, pictures.width, pictures.height));
    }
    const std::string& file = domain.kind == DomainKind::Image ? domain.path : domain.texture;
    if (file.empty() || domain.kind == DomainKind::Surface) return nullptr;
    const DrawnSize size = domain.kind == DomainKind::Image ? domain.size : DrawnSize{};
    return std::make_shared<const Image>(readImage(pathIn(folder, file), size, notices));
}

Outline domainOutline(const Domain& domain, const Image& picture) {
    if (domain.outline == OutlineKind::Polygons) return domain.polygons;
    if (domain.outline == OutlineKind::Alpha) return outlineFromAlpha(picture, domain.alpha);
    return frameOutline(picture.width, picture.height);
}

std::shared_ptr<const SimplicialMesh<2>> meshPicture(const Domain& domain, const Design& design,
                                                     const Outline& outline, std::stop_token stop) {
    PlanarMeshOptions options;
    options.vertices = domain.vertices;
    options.edge = domain.edge;
    options.simplify = outlineSlack(domain);
    options.points = handlePoints(design, outline);
    struct Size {
        Region<2> shape;
        double feather, factor;
    };
    std::vector<Size> sizes;
    for (const ValueLayer& layer : domain.sizes)
        for (const SoftRegion& region : layer.regions)
            sizes.push_back({inPlane(region.shape), region.feather, layer.value});
    if (!sizes.empty())
        options.factor = [&sizes](const Vec2& p) {
            double factor = 1;
            for (const Size& size : sizes)
                factor += membership<2>(size.shape, p, size.feather) * (size.factor - factor);
            return factor;
        };
    options.stop = stop;
    return std::make_shared<const SimplicialMesh<2>>(meshOutline(outline, options));
}

void tellOfAim(const Domain& domain, const SimplicialMesh<2>& mesh, std::vector<Message>& notices) {
    if (domain.edge > 0 || mesh.vertexCount() <= kPromised * domain.vertices) return;
    notices.emplace_back(
        sentence("Core", "the mesh has %1 vertices, where %2 were aimed at: its outline needs them"),
        mesh.vertexCount(), domain.vertices);
}

int restMarginOf(const Domain& domain) {
    if (domain.kind != DomainKind::Image || domain.outline != OutlineKind::Alpha) return 0;
    return static_cast<int>(std::ceil(domain.alpha.margin + domain.alpha.gap)) + 1;
}

Texture textureOf(const Image& picture, std::shared_ptr<const SimplicialMesh<2>> rest,
                  const Eigen::Matrix2Xd& uv) {
    Texture texture{rest, {}};
    if (uv.cols() != rest->points.cols() || uv.cols() == 0) return texture;
    SimplicialMesh<2> pixels = *rest;
    pixels.points.row(0) = picture.width * uv.row(0);
    pixels.points.row(1) = picture.height * (1 - uv.row(1).array());
    // Least squares for pixels = [A b] [p; 1], over the vertices that cells have.
    const std::vector<bool> used = usedVertices<2>(rest->vertexCount(), rest->cells);
    std::vector<int> rows;
    for (int v = 0; v < rest->vertexCount(); ++v)
        if (used[v]) rows.push_back(v);
    const Eigen::MatrixX3d ones = rest->points(Eigen::all, rows).transpose().rowwise().homogeneous();
    const Eigen::MatrixX2d targets = pixels.points(Eigen::all, rows).transpose();
    const Eigen::Matrix<double, 3, 2> fit = leastSquares<3, 2>(ones, targets).X;
    texture.toPixels = {fit.topRows<2>().transpose(), fit.row(2).transpose()};
    texture.rest = std::make_shared<const SimplicialMesh<2>>(std::move(pixels));
    return texture;
}

Shape<2> loadFlatMesh(const Domain& domain, const std::string& folder) {
    const std::string path = pathIn(folder, domain.path);
    Shape<2> shape;
    const auto file = sharedMeshFile(path);
    std::shared_ptr<const SimplicialMesh<2>> textured;
    if (isVolume(*file))
        throw InputError(path, sentence("Core", "holds tetrahedra, but the project is in the plane"));
    try {
        textured = std::make_shared<const SimplicialMesh<2>>(meshFrom<2>(*file));
        shape.rest = joinedRest<2>(*textured, shape.notices, carriedNodes(*file));
    } catch (const InputError& error) {
        throw error.named(path);
    }
    shape.source = file;
    shape.plane = planeOf(pointsOf(*file), trianglesOf(*file)).value_or(PlaneFrame());
    shape.picture = loadPicture(domain, folder, &shape.notices);
    // On the file's own cells: at a seam, vertices at one place have texture points of their own.
    if (shape.picture)
        shape.texture = std::make_shared<const Texture>(textureOf(*shape.picture, textured, uvOf(*file)));
    return shape;
}

const SimplicialMesh<2>& restInPixels(const Shape<2>& shape) {
    return shape.texture ? *shape.texture->rest : *shape.rest;
}

Points2 inPixels(const Shape<2>& shape, const Points2& pose) {
    return shape.texture ? shape.texture->toPixels(shape.texture->withRiders(pose)) : pose;
}

Points2 Texture::withRiders(const Points2& pose) const {
    if (riders.empty()) return pose;
    Points2 points(2, rest->vertexCount());
    points.leftCols(pose.cols()) = pose;
    Eigen::Index at = pose.cols();
    for (const Rider& rider : riders) {
        const Points2 own = rider.embedding.carry(rider.host, pose);
        points.middleCols(at, own.cols()) = own;
        at += own.cols();
    }
    return points;
}

std::vector<BlendMode> Texture::blends() const {
    std::vector<BlendMode> modes;
    for (const Sheet& sheet : sheets) modes.push_back(sheet.blend);
    const bool isPlain = std::ranges::count(modes, BlendMode::Normal) == std::ssize(modes);
    return isPlain ? std::vector<BlendMode>() : modes;
}

std::shared_ptr<const SimplicialMesh<2>> drawnRest(const Shape<2>& shape) {
    return shape.texture && shape.texture->drawn ? shape.texture->drawn : shape.rest;
}

const SimplicialMesh<2>& sourceRest(const Shape<2>& shape) {
    return shape.texture && shape.texture->drawn ? *shape.texture->drawn : restInPixels(shape);
}

std::array<int, 2> canvasSize(const Shape<2>& shape) {
    const bool isGiven = shape.texture && shape.texture->width > 0;
    return isGiven ? std::array{shape.texture->width, shape.texture->height}
                   : std::array{shape.picture->width, shape.picture->height};
}

}  // namespace wend
