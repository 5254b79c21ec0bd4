#include "app/session/caged_solid.h"

#include <algorithm>

#include "app/document/design.h"
#include "app/document/domain.h"
#include "core/mesh/error.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/cage.h"

namespace wend {
namespace {

constexpr double kFarTooMany = 8;  // times the vertices that are aimed at
const char* const kGroup = "cage";

/// Different places, of vertices that triangles have.
int placeCount(const Skin& skin) {
    const std::vector<int> first = firstAtPlace<3>(skin.points);
    std::vector<bool> used(first.size(), false);
    for (const auto& triangle : skin.triangles)
        for (const int v : triangle) used[first[v]] = true;
    return static_cast<int>(std::ranges::count(used, true));
}

std::shared_ptr<const MeshFile> fileOf(const SimplicialMesh<3>& mesh) {
    auto file = std::make_shared<MeshFile>(toMeshFile<3>(mesh));
    file->made = true;
    for (const auto& facet : facetsOf(mesh))
        if (!facet.interior()) file->triangles.push_back(facet.vertices);
    file->labels.assign(file->triangles.size(), 1);
    file->labelNames = {kGroup};
    return file;
}

void tellOfParts(const Domain& domain, const Cage& cage, Advice advice, Shape<3>& solid) {
    if (cage.apart < cage.parts)
        solid.notices.push_back(
            "its " + std::to_string(cage.parts) + " parts share cells of the cage and move together as " +
            std::to_string(cage.apart) + ": smaller cells keep more of them apart" +
            (advice == Advice::Keys ? (domain.maxVolume > 0 ? " (`maxVolume`)" : " (`vertices`)") : ""));
    if (cage.bodies > 1)
        solid.notices.push_back(
            "the cage is in " + std::to_string(cage.bodies) +
            " bodies that do not hang together: each needs a handle of its own to follow");
}

void tellOfCage(const Domain& domain, const Cage& cage, const std::string& why, Advice advice,
                Shape<3>& solid) {
    const std::string size = std::to_string(cage.mesh.vertexCount()) + " vertices";
    if (!why.empty())
        solid.notices.push_back("the surface is embedded in a cage of " + size + ", since " + why);
    if (!cage.aimMet)
        solid.notices.push_back(
            domain.maxVolume > 0
                ? "the cells of the cage are larger than asked for: there is no memory for smaller ones"
                : "the cage has " + size + ", where " + std::to_string(domain.vertices) +
                      " were aimed at: whole cubes allow nothing nearer");
    if (!domain.sizes.empty() || !domain.sizesFile.empty())
        solid.notices.push_back("sizes are for the exact surface: a cage has cells of one size");
    tellOfParts(domain, cage, advice, solid);
}

}  // namespace

Shape<3> cagedSolid(const Domain& domain, const std::shared_ptr<const Skin>& skin, const std::string& why,
                    std::stop_token stop, Advice advice) {
    CageOptions options;
    options.vertices = domain.vertices;
    options.maxVolume = domain.maxVolume;
    options.detail = domain.cageDetail;
    options.offset = domain.cageOffset;
    options.stop = stop;
    const Cage cage = fitCage(surfaceOf(*skin), options);
    Shape<3> solid;
    solid.cage = CageFacts{why, cage.edge, cage.bodies, cage.parts, cage.apart};
    tellOfCage(domain, cage, why, advice, solid);
    solid.verdict = verdictOn(cage.mesh, {}, domain.quality, false);
    solid.rest = std::make_shared<const SimplicialMesh<3>>(cage.mesh);
    solid.source = fileOf(cage.mesh);
    solid.skin = skin;
    return solid;
}

bool isCage(const MeshFile& made, const Skin& skin) {
    return made.made && made.labelNames != skin.labelNames &&
           made.labelNames == std::vector<std::string>{kGroup};
}

std::string tooManyVertices(const Domain& domain, const Design<3>& design, const Skin& skin) {
    const auto byNumber = [](const Handle<3>& handle) {
        return std::holds_alternative<std::vector<int>>(handle.at);
    };
    if (domain.maxVolume > 0 || std::ranges::any_of(design.handles, byNumber)) return {};
    const int count = placeCount(skin);
    if (count <= kFarTooMany * domain.vertices) return {};
    return "it has " + std::to_string(count) + " vertices, where " + std::to_string(domain.vertices) +
           " were aimed at";
}

bool liesInAPlane(const Skin& skin) {
    return checkSurface(surfaceOf(skin), 0).flat;
}

bool canBeCaged(const Skin& skin) {
    const auto finite = [&](const std::array<int, 3>& t) {
        return std::ranges::all_of(
            t, [&](int v) { return v >= 0 && v < skin.vertexCount() && skin.points.col(v).allFinite(); });
    };
    return !skin.triangles.empty() && std::ranges::all_of(skin.triangles, finite) && placeCount(skin) > 1;
}

}  // namespace wend
