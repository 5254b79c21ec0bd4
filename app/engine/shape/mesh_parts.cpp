#include "app/engine/shape/mesh_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/disjoint_sets.h"
#include "core/mesh/boundary_loops.h"
#include "core/mesh/point_locator.h"

namespace wend {

namespace {

constexpr double kRoom = 1e-3;  // fraction of the extent by which a region exceeds its contents

template <int Dim>
Box<Dim> boxAround(const SimplicialMesh<Dim>& mesh, const std::vector<int>& cells) {
    Box<Dim> box{Vec<Dim>::Constant(INFINITY), Vec<Dim>::Constant(-INFINITY)};
    for (const int c : cells)
        for (const int v : mesh.cells[c]) {
            box.min = box.min.cwiseMin(mesh.points.col(v));
            box.max = box.max.cwiseMax(mesh.points.col(v));
        }
    const double room = kRoom * (box.max - box.min).norm();
    return {box.min.array() - room, box.max.array() + room};
}

double twiceArea(const std::vector<Vec2>& loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice);
}

/// Returns the largest loop of the boundary of some cells.
Polygon outlineOf(const SimplicialMesh<2>& mesh, const std::vector<int>& cells) {
    SimplicialMesh<2> part{mesh.points, {}};
    for (const int c : cells) part.cells.push_back(mesh.cells[c]);
    Polygon best;
    for (auto& loop : boundaryLoops(part))
        if (twiceArea(loop) > twiceArea(best.points)) best.points = std::move(loop);
    return best;
}

std::vector<Cell<2>> cellsOfPart(const SimplicialMesh<2>& rest, const MeshPart& part) {
    return {rest.cells.begin() + part.firstCell, rest.cells.begin() + part.endCell};
}

}  // namespace

template <int Dim>
std::vector<int> partOf(const SimplicialMesh<Dim>& mesh, int cell) {
    DisjointSets sets(mesh.cellCount());
    for (const Facet<Dim>& facet : facetsOf(mesh))
        if (facet.interior()) sets.join(facet.cells[0], facet.cells[1]);
    std::vector<int> part;
    for (int c = 0; c < mesh.cellCount(); ++c)
        if (sets.root(c) == sets.root(cell)) part.push_back(c);
    return part;
}

std::string partNameOf(const std::vector<MeshPart>& parts, int cell) {
    for (const MeshPart& part : parts)
        if (part.firstCell <= cell && cell < part.endCell) return part.name;
    return {};
}

template <int Dim>
Region<Dim> regionOfAll(const SimplicialMesh<Dim>& mesh) {
    std::vector<int> all(mesh.cells.size());
    std::iota(all.begin(), all.end(), 0);
    return boxAround(mesh, all);
}

template <int Dim>
Region<Dim> regionAround(const SimplicialMesh<Dim>& mesh, const std::vector<int>& cells) {
    if constexpr (Dim == 2) {
        return outlineOf(mesh, cells);
    } else {
        return boxAround(mesh, cells);
    }
}

#define WEND_INSTANTIATE(Dim)                                                                    \
    template std::vector<int> partOf<Dim>(const SimplicialMesh<Dim>&, int);                      \
    template Region<Dim> regionAround<Dim>(const SimplicialMesh<Dim>&, const std::vector<int>&); \
    template Region<Dim> regionOfAll<Dim>(const SimplicialMesh<Dim>&)
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

std::optional<Vec2> jointPlace(const SimplicialMesh<2>& rest, const std::string& part,
                               const std::string& other) {
    const auto own = std::ranges::find(rest.parts, part, &MeshPart::name),
               to = std::ranges::find(rest.parts, other, &MeshPart::name);
    if (own == rest.parts.end() || to == rest.parts.end()) return std::nullopt;
    const std::vector<Cell<2>> ownCells = cellsOfPart(rest, *own), otherCells = cellsOfPart(rest, *to);
    const PointLocator<2> inOwn(rest.points, ownCells), inOther(rest.points, otherCells);
    std::vector<Vec2> shared;
    Vec2 middle = Vec2::Zero();
    for (int v = own->firstVertex; v < own->endVertex; ++v)
        if (const Vec2 p = rest.points.col(v); inOther.find(p)) {
            shared.push_back(p);
            middle += p;
        }
    if (shared.empty()) return std::nullopt;
    middle /= static_cast<double>(shared.size());
    if (inOwn.find(middle) && inOther.find(middle)) return middle;
    return *std::ranges::min_element(shared, {}, [&](const Vec2& p) { return (p - middle).squaredNorm(); });
}

}  // namespace wend
