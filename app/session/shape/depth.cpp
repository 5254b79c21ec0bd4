#include "app/session/shape/depth.h"

#include <algorithm>

#include "core/mesh/limb_order.h"

namespace wend {

namespace {

Vec<2> triangleCentroid(const SimplicialMesh<2>& mesh, const Cell<2>& cell) {
    return (mesh.points.col(cell[0]) + mesh.points.col(cell[1]) + mesh.points.col(cell[2])) / 3;
}

float orderAt(const std::vector<DepthRegion>& regions, const Vec<2>& p) {
    const auto last = std::find_if(regions.rbegin(), regions.rend(), [&](const DepthRegion& region) {
        return signedDistance<2>(region.shape, p) <= 0;
    });
    return last == regions.rend() ? 0 : static_cast<float>(last->order);
}

}  // namespace

std::vector<float> cellOrders(const std::vector<DepthRegion>& regions, const SimplicialMesh<2>& rest) {
    if (regions.empty()) return {};
    std::vector<float> depths;
    depths.reserve(rest.cells.size());
    for (const Cell<2>& cell : rest.cells) depths.push_back(orderAt(regions, triangleCentroid(rest, cell)));
    const bool flat = std::ranges::all_of(depths, [&](float depth) { return depth == depths.front(); });
    return flat ? std::vector<float>() : depths;
}

std::vector<float> cellDepths(const std::vector<DepthRegion>& regions, const SimplicialMesh<2>& rest) {
    std::vector<float> depths = cellOrders(regions, rest);
    if (depths.empty()) depths.assign(rest.cells.size(), 0);
    std::vector<float> levels = depths;
    std::ranges::sort(levels);
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    const std::vector<int> place = limbOrder(rest);
    for (std::size_t c = 0; c < depths.size(); ++c)  // the level, and less than a half for the place
        depths[c] = static_cast<float>(std::ranges::lower_bound(levels, depths[c]) - levels.begin()) +
                    0.5F * static_cast<float>(place[c]) / static_cast<float>(place.size());
    return depths;
}

const CellDepths::Values& CellDepths::of(const std::vector<DepthRegion>& regions,
                                         const std::shared_ptr<const SimplicialMesh<2>>& rest) {
    if (m_values && rest == m_rest && regions == m_regions) return m_values;
    m_regions = regions;
    m_rest = rest;
    m_values = std::make_shared<const std::vector<float>>(m_make(regions, *rest));
    m_plan.reset();
    return m_values;
}

std::shared_ptr<const PaintingPlan> CellDepths::plan() {
    if (!m_plan) m_plan = std::make_shared<PaintingPlan>(*m_rest, *m_values);
    return m_plan;
}

}  // namespace wend
