#include "app/engine/shape/caged_solid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/options/options.h"
#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/cage.h"

namespace wend {
namespace {

constexpr double kFarTooMany = 8;     // times the vertices that are aimed at
constexpr double kMostToOffer = 1e6;  // vertices
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

std::string textOf(const Vec<3>& place) {
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

}  // namespace

void GapOpener::applyTo(Domain& domain) const {
    if (detail > 0) domain.cageDetail = detail;
    if (maxVolume > 0) domain.maxVolume = maxVolume;
    if (vertices > 0) domain.vertices = vertices;
}

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

Message tooManyVertices(const Domain& domain, const Design& design, const Skin& skin) {
    const auto byNumber = [](const Pin& handle) {
        return std::holds_alternative<std::vector<int>>(handle.at);
    };
    if (domain.maxVolume > 0 || std::ranges::any_of(design.handles, byNumber)) return {};
    const int count = placeCount(skin);
    if (count <= kFarTooMany * domain.vertices) return {};
    return {sentence("Core", "it has %1 vertices, where %2 were aimed at"), count, domain.vertices};
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
