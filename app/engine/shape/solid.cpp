#include "app/engine/shape/solid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/engine/shape/mesh_rest.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "app/project/options/options.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/mesh/file_cells.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/point_locator.h"
#include "core/mesh/skin_file.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/cage.h"
#include "core/meshing/seam_weld.h"
#include "core/meshing/volume_mesher.h"

namespace wend {

namespace {

constexpr double kFarTooMany = 8;     // times the vertices that are aimed at
constexpr double kMostToOffer = 1e6;  // vertices
const char* const kGroup = "cage";

/// Counts the different places of vertices that triangles have.
int placeCount(const Skin& skin) {
    const std::vector<int> first = firstAtPlace<3>(skin.points);
    std::vector<bool> used(first.size(), false);
    for (const auto& triangle : skin.triangles)
        for (const int v : triangle) used[first[v]] = true;
    return static_cast<int>(std::ranges::count(used, true));
}

std::shared_ptr<const MeshFile> fileOf(const SimplicialMesh<3>& mesh) {
    std::vector<std::array<int, 3>> boundary;
    for (const auto& facet : facetsOf(mesh))
        if (!facet.interior()) boundary.push_back(facet.vertices);
    return madeMeshFile(mesh, boundary, {std::vector<int>(boundary.size(), 1), {kGroup}});
}

void tellOfParts(const Domain& domain, const Cage& cage, Advice advice, Shape<3>& solid) {
    if (cage.apart < cage.parts) {
        const Message apart(
            sentence("Core",
                     "its %1 parts share cells of the cage and move together as %2: smaller cells keep "
                     "more of them apart"),
            cage.parts, cage.apart);
        solid.notices.push_back(advice == Advice::Keys
                                    ? apart + (domain.maxVolume > 0 ? " (`maxVolume`)" : " (`vertices`)")
                                    : apart);
    }
    if (cage.bodies > 1)
        solid.notices.emplace_back(sentence("Core",
                                            "the cage consists of %1 bodies that are not connected: each "
                                            "needs a handle of its own to follow"),
                                   cage.bodies);
}

std::string fourDigits(double value) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 4);
    return {text.data(), end.ptr};
}

/// Rounds up to two digits.
double roundedUp(double value) {
    const double power = std::floor(std::log10(value)) - 1, unit = std::pow(10, std::abs(power));
    const double digits = std::ceil((power < 0 ? value * unit : value / unit) - 1e-9);
    return power < 0 ? digits / unit : digits * unit;
}

GapOpener openerOf(const Domain& domain, const Cage& cage) {
    if (cage.gaps.empty()) return {};
    GapOpener opener;
    if (cage.openDetail > 0) opener.detail = roundedUp(cage.openDetail);
    if (cage.openEdge == 0) return opener;
    const double vertices = cage.mesh.vertexCount() * std::pow(cage.edge / cage.openEdge, 3);
    if (vertices > kMostToOffer) return {};
    if (domain.maxVolume > 0)
        opener.maxVolume = roundedUp(0.9 * std::pow(cage.openEdge, 3) / 12);
    else
        opener.vertices = static_cast<int>(roundedUp(vertices));
    return opener;
}

std::string textOf(const Vec3& place) {
    return '(' + fourDigits(place.x()) + ", " + fourDigits(place.y()) + ", " + fourDigits(place.z()) + ')';
}

/// Returns what closes a gap, followed by what opens it.
Message withOpener(const Message& gaps, const GapOpener& opener) {
    const std::string detail = fourDigits(opener.detail), volume = fourDigits(opener.maxVolume);
    const bool also = opener.detail > 0;
    if (opener.maxVolume > 0 && also)
        return {sentence("Core", "%1; a detail of %2 and cells of at most %3 open the widest"), gaps, detail,
                volume};
    if (opener.maxVolume > 0)
        return {sentence("Core", "%1; cells of at most %2 open the widest"), gaps, volume};
    if (opener.vertices > 0 && also)
        return {sentence("Core", "%1; a detail of %2 and about %3 vertices open the widest"), gaps, detail,
                opener.vertices};
    if (opener.vertices > 0)
        return {sentence("Core", "%1; about %2 vertices open the widest"), gaps, opener.vertices};
    return also ? Message(sentence("Core", "%1; a detail of %2 opens the widest"), gaps, detail) : gaps;
}

void tellOfGaps(const Domain& domain, const Cage& cage, Shape<3>& solid) {
    if (cage.gaps.empty()) return;
    const ClosedGap& first = cage.gaps.front();
    const std::string size = fourDigits(first.width), place = textOf(first.place);
    const Message gaps =
        cage.gaps.size() == 1
            ? Message(
                  sentence(
                      "Core",
                      "the cage closes a gap within one part, %1 wide near %2: what lies on both sides moves "
                      "together"),
                  size, place)
            : Message(
                  sentence(
                      "Core",
                      "the cage closes %1 gaps within one part, the narrowest %2 wide near %3: what lies on "
                      "both sides moves together"),
                  cage.gaps.size(), size, place);
    solid.notices.push_back(withOpener(gaps, openerOf(domain, cage)));
}

void tellOfCage(const Domain& domain, const Cage& cage, const Message& why, Advice advice, Shape<3>& solid) {
    const int count = cage.mesh.vertexCount();
    if (!why.isEmpty())
        solid.notices.emplace_back(
            sentence("Core", "the surface is embedded in a cage of %1 vertices, since %2"), count, why);
    if (!cage.aimMet && domain.maxVolume > 0)
        solid.notices.emplace_back(sentence(
            "Core", "the cells of the cage are larger than asked for: there is no memory for smaller ones"));
    if (!cage.aimMet && domain.maxVolume <= 0)
        solid.notices.emplace_back(
            sentence("Core",
                     "the cage has %1 vertices, where %2 were aimed at: whole cubes allow nothing nearer"),
            count, domain.vertices);
    if (!domain.sizes.empty() || !domain.sizesFile.empty())
        solid.notices.emplace_back(
            sentence("Core", "sizes are for the exact surface: a cage has cells of one size"));
    tellOfParts(domain, cage, advice, solid);
    tellOfGaps(domain, cage, solid);
}

/// Makes a cage of even cells that a surface is embedded in; `why` is the reason for an automatic choice, and
/// is empty if a cage was asked for. Throws InputError, Cancelled.
Shape<3> cagedSolid(const Domain& domain, const std::shared_ptr<const Skin>& skin, const Message& why,
                    std::stop_token stop, Advice advice) {
    CageOptions options;
    options.vertices = domain.vertices;
    options.maxVolume = domain.maxVolume;
    options.detail = domain.cageDetail;
    options.offset = domain.cageOffset;
    options.stop = stop;
    const Cage cage = fitCage(surfaceOf(*skin), options);
    Shape<3> solid;
    solid.cage =
        CageFacts{why, cage.edge, cage.bodies, cage.parts, cage.apart, cage.gaps, openerOf(domain, cage)};
    tellOfCage(domain, cage, why, advice, solid);
    solid.verdict = verdictOn(cage.mesh, {}, domain.quality, false);
    solid.rest = std::make_shared<const SimplicialMesh<3>>(cage.mesh);
    solid.source = fileOf(cage.mesh);
    solid.skin = skin;
    return solid;
}

/// Returns why the exact surface is not even tried: it has more than eight times the vertices that are aimed
/// at. Empty otherwise, and where handles name its vertices by number.
Message tooManyVertices(const Domain& domain, const Design& design, const Skin& skin) {
    const auto byNumber = [](const Pin& handle) {
        return std::holds_alternative<std::vector<int>>(handle.at);
    };
    if (domain.maxVolume > 0 || std::ranges::any_of(design.handles, byNumber)) return {};
    const int count = placeCount(skin);
    if (count <= kFarTooMany * domain.vertices) return {};
    return {sentence("Core", "it has %1 vertices, where %2 were aimed at"), count, domain.vertices};
}

/// Flat surfaces open as 2D meshes; a cage is built only on request.
bool liesInAPlane(const Skin& skin) {
    return checkSurface(surfaceOf(skin), 0).flat;
}

/// Returns whether there is a surface to build a cage around.
bool canBeCaged(const Skin& skin) {
    const auto finite = [&](const std::array<int, 3>& t) {
        return std::ranges::all_of(
            t, [&](int v) { return v >= 0 && v < skin.vertexCount() && skin.points.col(v).allFinite(); });
    };
    return !skin.triangles.empty() && std::ranges::all_of(skin.triangles, finite) && placeCount(skin) > 1;
}

/// Returns sizes of 1 times the painted factors, and then the regions one after another.
SizeGrid sizesOf(const Domain& domain, const std::string& folder, const Surface& surface) {
    if (domain.sizes.empty() && domain.sizesFile.empty()) return {};
    std::vector<double> painted;
    if (!domain.sizesFile.empty())
        painted = readSizes(pathIn(folder, domain.sizesFile), surface.vertexCount());
    const std::vector<Cell<3>> noCells;
    const PointLocator<3> locator(surface.points, noCells);
    return sampleSizes(surface, [&](const Vec3& p) {
        double factor = painted.empty() ? 1 : painted[locator.nearestVertex(p)];
        for (const ValueLayer& layer : domain.sizes)
            for (const SoftRegion& region : layer.regions)
                factor += membership<3>(region.shape, p, region.feather) * (layer.value - factor);
        return factor;
    });
}

VolumeMeshOptions meshOptions(const Domain& domain, const std::string& folder, const Surface& surface,
                              std::stop_token stop) {
    VolumeMeshOptions options;
    options.quality = domain.quality;
    options.maxVolume = domain.maxVolume;
    options.vertices = domain.maxVolume > 0 ? 0 : domain.vertices;
    options.keepSurface = !domain.refineSurface;
    options.shells = domain.shells;
    options.sizes = sizesOf(domain, folder, surface);
    options.stop = stop;
    return options;
}

/// The result of a repair: what it did, and what it left undone regardless of the limit.
struct Repairing {
    Message done, undone;
};

/// Suggests a higher limit for holes.
Message largerHoles(const RepairReport& report, int limit, Advice advice) {
    if (report.largerHoles.empty()) return {};
    const int largest = report.largerHoles.back();
    const std::size_t count = report.largerHoles.size();
    const Message open =
        count == 1
            ? Message(sentence("Core", "1 hole of %1 edges stayed open, larger than the limit of %2"),
                      largest, limit)
            : Message(sentence("Core", "%1 holes of up to %2 edges stayed open, larger than the limit of %3"),
                      count, largest, limit);
    if (advice != Advice::Keys) return open;
    return open + ": `largestHole` or --largest-hole " +
           (std::to_string(largest) + (count == 1 ? " fills it" : " fills them"));
}

Message weldText(const SeamWeld& weld) {
    if (weld.vertices == 0) return {};
    const std::string gap = shortNumber(weld.tolerance);
    if (weld.vertices == 1)
        return {sentence("Core", "1 vertex of open seams welded, the widest gap %1"), gap};
    return {sentence("Core", "%1 vertices of open seams welded, the widest gap %2"), weld.vertices, gap};
}

/// Single faults first, then seams, then as many as the simple repairs do.
Surface repaired(const Surface& surface, const Domain& domain, Shape<3>& solid, Repairing& repairing,
                 Advice advice) {
    RepairReport report;
    Surface better = fixSurface(surface, domain.fixes).surface;
    SeamWeld weld;
    if (domain.repair) {
        weld = weldSeams(better);
        better = repairSurface(better, domain.largestHole, report);
    }
    report.steps = static_cast<int>(domain.fixes.size());
    repairing.done = listed({weldText(weld), report.summary()});
    repairing.undone = largerHoles(report, domain.largestHole, advice);
    if (!repairing.done.isEmpty())
        solid.notices.emplace_back(sentence("Core", "the surface was repaired: %1"), repairing.done);
    return better;
}

bool repairHelps(Surface surface, int largestHole) {
    RepairReport report;
    weldSeams(surface);
    return checkSurface(repairSurface(surface, largestHole, report)).boundsVolume();
}

Message help(const Surface& surface, const Domain& domain, const Repairing& repairing, Advice advice) {
    Message text;
    if (!repairing.done.isEmpty()) text = {sentence("Core", " (after the repair: %1)"), repairing.done};
    if (!domain.repair) {
        if (advice == Advice::None) return {};
        return text += repairHelps(surface, domain.largestHole)
                           ? "; `wend info` lists them, `repair` may help"
                           : "; `wend info` lists them";
    }
    if (text.isEmpty()) text = sentence("Core", "; the repair found nothing that it could repair");
    return repairing.undone.isEmpty() ? text : text + "; " + repairing.undone;
}

VolumeMesh meshed(const Surface& surface, const VolumeMeshOptions& options, const Domain& domain,
                  const Repairing& repairing, Advice advice) {
    try {
        return meshVolume(surface, options);
    } catch (const SurfaceError& error) {
        throw SurfaceError(error.message() + help(surface, domain, repairing, advice), error.problems);
    }
}

/// Far coarser triangles than cells: the mesher cannot split them, and crowds its vertices in places.
bool surfaceIsTooCoarse(const Surface& surface, const SimplicialMesh<3>& mesh) {
    double volume = 0, length = 0;
    for (const auto& cell : mesh.cells) volume += cellMeasure<3>(mesh.points, cell);
    for (const auto& t : surface.triangles)
        for (int k = 0; k < 3; ++k)
            length += (surface.points.col(t[k]) - surface.points.col(t[(k + 1) % 3])).norm();
    const double ofTriangles = length / (3.0 * surface.triangleCount());
    const double ofCells = std::cbrt(6 * std::sqrt(2.0) * volume / mesh.cellCount());  // regular ones
    return ofTriangles > 2 * ofCells;
}

/// Reports which targets the mesh missed, and the key to change.
void tellOfMesh(const Domain& domain, const Surface& surface, const VolumeMesh& volume, Advice advice,
                Shape<3>& solid) {
    const bool keys = advice == Advice::Keys;
    if (!volume.aimMet) {
        const Message missed(
            domain.refineSurface
                ? sentence(
                      "Core",
                      "the mesh has %1 vertices, where %2 were aimed at: the quality asked for needs them")
                : sentence("Core",
                           "the mesh has %1 vertices, where %2 were aimed at: the surface is kept as it is"),
            volume.usedCount(), domain.vertices);
        solid.notices.push_back(keys && !domain.refineSurface ? missed + " (see `refineSurface`)" : missed);
    }
    const bool coarse = !domain.refineSurface && surfaceIsTooCoarse(surface, volume.mesh);
    if (coarse) {
        const Message uneven = sentence(
            "Core",
            "the surface's triangles are far larger than the cells inside and are kept as they are, which "
            "makes uneven cells");
        solid.notices.push_back(keys ? uneven + ": `refineSurface` splits them" : uneven);
    }
    if (const Message text = solid.verdict->text(); !text.isEmpty()) solid.notices.push_back(text);
    solid.refineHelps = coarse || (!volume.aimMet && !domain.refineSurface && domain.vertices > 0 &&
                                   volume.usedCount() < domain.vertices);
}

/// Tells what several spaces are taken for, unless the project says it.
void tellOfSpaces(const Domain& domain, const ShellSpaces& spaces, Advice advice, Shape<3>& solid) {
    const Message text = spaces.summary();
    if (text.isEmpty() || domain.shells != Shells::Automatic) return;
    solid.notices.push_back(advice == Advice::Keys
                                ? text +
                                      "; `shells`: \"regions\" fills all and labels their cells, \"holes\" "
                                      "leaves every second one hollow"
                                : text);
}

void tellOfSpares(const VolumeMesh& volume, Shape<3>& solid) {
    const int spare = volume.mesh.vertexCount() - volume.usedCount();
    if (spare == 1)
        solid.notices.emplace_back(sentence(
            "Core",
            "1 vertex of the surface belongs to no tetrahedron: meshes of tetrahedra are written without it, "
            "so that later vertices have other numbers"));
    if (spare > 1)
        solid.notices.emplace_back(sentence("Core",
                                            "%1 vertices of the surface belong to no tetrahedron: meshes of "
                                            "tetrahedra are written without "
                                            "them, so that later vertices have other numbers"),
                                   spare);
}

Shape<3> exactSolid(const Domain& domain, const std::shared_ptr<const Skin>& skin,
                    const VolumeMeshOptions& options, Advice advice) {
    Shape<3> solid;
    Surface surface = surfaceOf(*skin);
    Repairing repairing;
    if (domain.repair || !domain.fixes.empty()) surface = repaired(surface, domain, solid, repairing, advice);
    const VolumeMesh volume = meshed(surface, options, domain, repairing, advice);
    solid.verdict =
        verdictOn(volume.mesh, surface, domain.quality, !domain.refineSurface && repairing.done.isEmpty());
    tellOfMesh(domain, surface, volume, advice, solid);
    tellOfSpares(volume, solid);
    tellOfSpaces(domain, volume.spaces, advice, solid);
    solid.rest = std::make_shared<const SimplicialMesh<3>>(volume.mesh);
    solid.source =
        madeMeshFile(volume.mesh, volume.boundary,
                     {skin->labels.empty() ? std::vector<int>() : volume.boundaryLabels, skin->labelNames},
                     {volume.cellLabels, volume.spaces.names});
    solid.hasSpaces = volume.spaces.deepest() > 1 || volume.spaces.shareWalls();
    solid.skin = skin;
    return solid;
}

/// Meshes the exact surface or a cage around it, as asked for; by default falls back to the cage where the
/// exact mesh fails.
Shape<3> fromSurface(const Domain& domain, const Design& design, const std::string& folder,
                     const std::stop_token& stop, Advice advice) {
    const auto skin = std::make_shared<const Skin>(readSkin(pathIn(folder, domain.path)));
    // Painted sizes belong to the vertices as the file has them.
    VolumeMeshOptions options = meshOptions(domain, folder, surfaceOf(*skin), stop);
    options.labelNames = skin->labelNames;
    if (domain.fit == Fit::Cage) return cagedSolid(domain, skin, {}, stop, advice);
    if (domain.fit == Fit::Exact) return exactSolid(domain, skin, options, advice);
    if (const Message why = tooManyVertices(domain, design, *skin); !why.isEmpty())
        return cagedSolid(domain, skin, why, stop, advice);
    try {
        return exactSolid(domain, skin, options, advice);
    } catch (const MesherLost&) {
        throw;
    } catch (const InputError& error) {
        if (!canBeCaged(*skin)) throw;
        if (liesInAPlane(*skin))
            throw InputError(error.message() + (advice == Advice::Keys ? "; `cage` makes a slab of it" : ""));
        return cagedSolid(domain, skin,
                          {sentence("Core", "it cannot be meshed as it is: %1"), error.message()}, stop,
                          advice);
    }
}

Shape<3> fromMesh(const Domain& domain, const std::string& folder) {
    const std::string path = pathIn(folder, domain.path);
    const auto file = sharedMeshFile(path);
    if (!isVolume(*file))
        throw InputError(path, sentence("Core", "holds no tetrahedra, but the project is in space"));
    Shape<3> solid;
    solid.rest = joinedRest<3>(meshFrom<3>(*file), solid.notices, carriedNodes(*file));
    solid.source = file;
    solid.skin = std::make_shared<const Skin>(boundaryOf(*solid.rest));
    return solid;
}

/// Takes a surface as the skin; points and polylines are kept beside it.
void takeDetail(const std::string& path, Shape<3>& solid) {
    const auto detail = std::make_shared<const Skin>(readSkin(path, MeshNeeds::Points));
    (detail->triangles.empty() ? solid.cloud : solid.skin) = detail;
}

void embed(Shape<3>& solid) {
    solid.embedding = std::make_shared<const Embedding<3>>(*solid.rest, solid.skin->points);
    if (solid.cloud)
        solid.cloudEmbedding = std::make_shared<const Embedding<3>>(*solid.rest, solid.cloud->points);
}

void tellOfOutside(const Domain& domain, Shape<3>& solid) {
    const int outside = solid.exportedEmbedding().outside(), all = solid.exported().vertexCount();
    if (!domain.detail.empty() && 2 * outside > all)
        solid.notices.push_back(
            domain.detail + ": " +
            Message(sentence("Core", "%1 of %2 vertices lie outside the solid that carries them"), outside,
                    all));
}

}  // namespace

void GapOpener::applyTo(Domain& domain) const {
    if (detail > 0) domain.cageDetail = detail;
    if (maxVolume > 0) domain.maxVolume = maxVolume;
    if (vertices > 0) domain.vertices = vertices;
}

Surface surfaceOf(const Skin& skin) {
    return {skin.points, skin.triangles, skin.labels};
}

Shape<3> loadSolid(const Domain& domain, const Design& design, const std::string& folder,
                   std::stop_token stop, Advice advice) {
    const std::string path = pathIn(folder, domain.path);
    Shape<3> solid;
    try {
        solid = domain.kind == DomainKind::Surface ? fromSurface(domain, design, folder, stop, advice)
                                                   : fromMesh(domain, folder);
    } catch (const SurfaceError& error) {
        throw SurfaceError(error, path);
    } catch (const InputError& error) {
        throw error.named(path);
    }
    if (!domain.detail.empty()) takeDetail(pathIn(folder, domain.detail), solid);
    if (stop.stop_requested()) throw Cancelled();
    for (const std::string& warning : solid.skin->warnings)
        solid.notices.push_back(solid.skin->path + ": " + warning);
    embed(solid);
    tellOfOutside(domain, solid);
    tellOfHanging<3>(*solid.rest, solid.notices);
    return solid;
}

}  // namespace wend
