#include "warp/coverage.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wend {
namespace {

bool before(const Vec2& a, const Vec2& b) {
    return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
}

}  // namespace

TriangleRows::TriangleRows(const Vec2& a, const Vec2& b, const Vec2& c) : TriangleRows(sorted({a, b, c})) {}

TriangleRows::Corners TriangleRows::sorted(Corners corners) {
    std::sort(corners.begin(), corners.end(), before);
    return corners;
}

PaintingPlan::PaintingPlan(const SimplicialMesh<2>& mesh, const std::vector<float>& depth)
    : order(mesh.cells.size()) {
    std::iota(order.begin(), order.end(), 0);
    if (!depth.empty())
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth[a] < depth[b]; });
    const auto level = [&](int cell) { return std::floor(depth[static_cast<std::size_t>(cell)]); };
    for (const auto& facet : facetsOf(mesh))
        if (!facet.interior() || (!depth.empty() && level(facet.cells[0]) != level(facet.cells[1])))
            outline.push_back(facet.vertices);
}

}  // namespace wend
