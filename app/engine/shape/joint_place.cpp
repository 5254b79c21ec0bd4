#include "app/engine/shape/joint_place.h"

#include <algorithm>

#include "core/mesh/point_locator.h"

namespace wend {

namespace {

std::vector<Cell<2>> cellsOfPart(const SimplicialMesh<2>& rest, const MeshPart& part) {
    return {rest.cells.begin() + part.firstCell, rest.cells.begin() + part.endCell};
}

}  // namespace

std::optional<Vec<2>> jointPlace(const SimplicialMesh<2>& rest, const std::string& part,
                                 const std::string& other) {
    const auto own = std::ranges::find(rest.parts, part, &MeshPart::name),
               to = std::ranges::find(rest.parts, other, &MeshPart::name);
    if (own == rest.parts.end() || to == rest.parts.end()) return std::nullopt;
    const std::vector<Cell<2>> ownCells = cellsOfPart(rest, *own), otherCells = cellsOfPart(rest, *to);
    const PointLocator<2> inOwn(rest.points, ownCells), inOther(rest.points, otherCells);
    std::vector<Vec<2>> shared;
    Vec<2> middle = Vec<2>::Zero();
    for (int v = own->firstVertex; v < own->endVertex; ++v)
        if (const Vec<2> p = rest.points.col(v); inOther.find(p)) {
            shared.push_back(p);
            middle += p;
        }
    if (shared.empty()) return std::nullopt;
    middle /= static_cast<double>(shared.size());
    if (inOwn.find(middle) && inOther.find(middle)) return middle;
    return *std::ranges::min_element(shared, {}, [&](const Vec<2>& p) { return (p - middle).squaredNorm(); });
}

}  // namespace wend
