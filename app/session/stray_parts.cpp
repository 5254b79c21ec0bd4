#include "app/session/stray_parts.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "app/engine/shape/shape.h"
#include "app/project/domain.h"
#include "app/project/edits/part_edits.h"
#include "app/session/shape_session.h"
#include "core/base/disjoint_sets.h"
#include "core/mesh/boundary_loops.h"

namespace wend {
namespace {

constexpr std::size_t kMostIslands = 24;  // more are noise
constexpr int kTried = 40;                // vertices of a part whose distance to others is measured

/// The vertices of a picture's mesh that move together: through cells and joints.
class HeldPieces {
  public:
    HeldPieces(const ShapeSession& session, const SimplicialMesh<2>& rest)
        : m_rest(rest), m_sets(rest.vertexCount()) {
        for (const Cell<2>& cell : rest.cells)
            for (const int v : cell) m_sets.join(cell[0], v);
        for (const Weld& weld : rest.welds)
            for (const auto& [v, weight] : weld.terms) m_sets.join(weld.terms.front().first, v);
        for (const auto& pins : {session.pins(true), session.ghosts()})
            for (const PinView& pin : pins)
                for (const Place& place : pin.places) m_held.insert(rootOfCell(place.cell));
    }

    int rootOfCell(int cell) { return m_sets.root(m_rest.cells[static_cast<std::size_t>(cell)][0]); }
    bool isHeld(int cell) { return m_held.contains(rootOfCell(cell)); }
    bool isAnyHeld() const { return !m_held.empty(); }

  private:
    const SimplicialMesh<2>& m_rest;
    DisjointSets m_sets;
    std::set<int> m_held;
};

double distanceBetween(const SimplicialMesh<2>& rest, const MeshPart& one, const MeshPart& other) {
    const int step = std::max(1, (one.endVertex - one.firstVertex) / kTried);
    double least = std::numeric_limits<double>::infinity();
    for (int v = one.firstVertex; v < one.endVertex; v += step)
        for (int w = other.firstVertex; w < other.endVertex; ++w)
            least = std::min(least, (rest.points.col(v) - rest.points.col(w)).squaredNorm());
    return least;
}

double areaOf(const SimplicialMesh<2>& rest, const MeshPart& part) {
    double area = 0;
    for (int c = part.firstCell; c < part.endCell; ++c)
        area += std::abs(cellMeasure<2>(rest.points, rest.cells[static_cast<std::size_t>(c)]));
    return area;
}

/// Parts whose cells are all stray, each with the nearest one that is held. A larger one is a ground, which
/// is to stay.
std::vector<StrayPart> strayOf(const std::vector<PicturePart>& parts, const SimplicialMesh<2>& rest,
                               HeldPieces& pieces) {
    std::vector<const MeshPart*> stray, held;
    for (const MeshPart& part : rest.parts) {
        bool isHeld = false;
        for (int c = part.firstCell; c < part.endCell && !isHeld; ++c) isHeld = pieces.isHeld(c);
        (isHeld ? held : stray).push_back(&part);
    }
    std::vector<StrayPart> found;
    const auto placeOf = [&](const std::string& name) {
        return static_cast<int>(std::ranges::find(parts, name, &PicturePart::name) - parts.begin());
    };
    for (const MeshPart* part : stray) {
        const auto nearest = std::ranges::min_element(
            held, {}, [&](const MeshPart* other) { return distanceBetween(rest, *part, *other); });
        if (nearest != held.end() && areaOf(rest, *part) < areaOf(rest, **nearest) &&
            mayRide(parts, placeOf(part->name), placeOf((*nearest)->name)))
            found.push_back({part->name, (*nearest)->name});
    }
    return found;
}

/// Islands of a picture without parts.
std::vector<StrayPart> islandsOf(const SimplicialMesh<2>& rest, HeldPieces& pieces) {
    std::map<int, SimplicialMesh<2>> islands;
    for (int c = 0; c < rest.cellCount(); ++c) {
        if (pieces.isHeld(c)) continue;
        SimplicialMesh<2>& island = islands[pieces.rootOfCell(c)];
        island.points = rest.points;
        island.cells.push_back(rest.cells[static_cast<std::size_t>(c)]);
        if (islands.size() > kMostIslands) return {};
    }
    std::vector<StrayPart> found;
    for (const auto& [root, island] : islands) found.push_back({{}, {}, {boundaryLoops(island)}});
    return found;
}

}  // namespace

std::vector<StrayPart> strayParts(const ShapeSession& session) {
    const auto frame = session.frame<2>();
    const Document& document = session.document();
    if (!frame || document.isEmpty() || document.domain().kind != DomainKind::Image) return {};
    HeldPieces pieces(session, *frame->rest);
    if (!pieces.isAnyHeld()) return {};
    const std::vector<PicturePart>& parts = document.domain().parts;
    return parts.empty() ? islandsOf(*frame->rest, pieces) : strayOf(parts, *frame->rest, pieces);
}

std::shared_ptr<const Project> withRiders(const Project& project, const std::vector<StrayPart>& strays) {
    auto next = copyOf(project);
    std::vector<PicturePart>& parts = domainOf(*next).parts;
    if (parts.empty()) {
        PicturePart& whole = parts.emplace_back();
        whole.path = std::exchange(domainOf(*next).path, {});
        whole.name = QFileInfo(QString::fromStdString(whole.path)).completeBaseName().toStdString();
    }
    const std::string whole = parts.back().name;
    int count = 0;
    for (const StrayPart& stray : strays) {
        if (!stray.name.empty()) {
            std::ranges::find(parts, stray.name, &PicturePart::name)->ridesOn = stray.host;
            continue;
        }
        PicturePart island;
        do island.name = QCoreApplication::translate("PartMaking", "Part %1").arg(++count).toStdString();
        while (std::ranges::find(parts, island.name, &PicturePart::name) != parts.end());
        island.cutFrom = island.ridesOn = whole;
        island.cut = stray.island;
        island.outline = PartOutline{OutlineKind::Alpha, {}, {}};
        parts.insert(parts.end() - 1, std::move(island));
    }
    return next;
}

}  // namespace wend
