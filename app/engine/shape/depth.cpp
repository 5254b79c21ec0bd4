#include "app/engine/shape/depth.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "app/engine/shape/mesh_parts.h"
#include "core/mesh/limb_order.h"

namespace wend {

namespace {

Vec2 triangleCentroid(const SimplicialMesh<2>& mesh, const Cell<2>& cell) {
    return (mesh.points.col(cell[0]) + mesh.points.col(cell[1]) + mesh.points.col(cell[2])) / 3;
}

float orderAt(const ValueLayers& layers, const std::string& part, const Vec2& p) {
    const auto reaches = [&](const SoftRegion& region) {
        return (region.part.empty() || region.part == part) &&
               signedDistance<2>(inPlane(region.shape), p) <= 0;
    };
    const auto last = std::find_if(layers.rbegin(), layers.rend(), [&](const ValueLayer& layer) {
        return std::ranges::any_of(layer.regions, reaches);
    });
    return last == layers.rend() ? 0 : static_cast<float>(last->value);
}

/// Lifts the cells of every part above those of all parts below it.
void lift(const SimplicialMesh<2>& mesh, const std::vector<int>& levels, std::vector<float>& depths) {
    if (levels.empty()) return;
    if (depths.empty()) depths.assign(mesh.cells.size(), 0);
    const auto [low, high] = std::ranges::minmax(depths);
    const float step = std::floor(high) - std::floor(low) + 1;
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        for (int c = mesh.parts[i].firstCell; c < mesh.parts[i].endCell; ++c)
            depths[static_cast<std::size_t>(c)] += step * static_cast<float>(levels[i]);
}

/// Returns the place of a part in the order at a time.
double placeAt(const std::vector<PicturePart>& parts, std::size_t part, double time) {
    double place = static_cast<double>(part);
    for (const PartOrder& order : parts[part].order)
        if (order.time <= time) place = order.place;
    return place;
}

}  // namespace

std::vector<int> partLevels(const std::vector<PicturePart>& parts, const SimplicialMesh<2>& mesh,
                            double time) {
    struct Place {
        double place;
        bool isOwn;  // no entry has moved it
        std::size_t part, mesh;
    };
    std::vector<Place> places;
    for (std::size_t k = 0; k < mesh.parts.size(); ++k) {
        const auto i = static_cast<std::size_t>(
            std::ranges::find(parts, mesh.parts[k].name, &PicturePart::name) - parts.begin());
        if (i == parts.size()) return {};
        const bool isMoved = !parts[i].order.empty() && parts[i].order.front().time <= time;
        places.push_back({placeAt(parts, i, time), !isMoved, i, k});
    }
    std::ranges::sort(places, std::greater<>(),
                      [](const Place& one) { return std::tuple(one.place, one.isOwn, one.part); });
    std::vector<int> levels(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) levels[places[k].mesh] = static_cast<int>(k);
    return levels;
}

std::vector<float> cellOrders(const ValueLayers& layers, const SimplicialMesh<2>& rest) {
    if (layers.empty()) return {};
    std::vector<float> depths;
    depths.reserve(rest.cells.size());
    for (std::size_t c = 0; c < rest.cells.size(); ++c)
        depths.push_back(orderAt(layers, partNameOf(rest.parts, static_cast<int>(c)),
                                 triangleCentroid(rest, rest.cells[c])));
    const bool flat = std::ranges::all_of(depths, [&](float depth) { return depth == depths.front(); });
    return flat ? std::vector<float>() : depths;
}

std::vector<float> cellDepths(const ValueLayers& layers, const SimplicialMesh<2>& rest) {
    std::vector<float> depths = cellOrders(layers, rest);
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

const CellDepths::Values& CellDepths::of(const ValueLayers& layers,
                                         const std::shared_ptr<const SimplicialMesh<2>>& rest,
                                         const std::vector<int>& levels) {
    if (m_values && rest == m_rest && layers == m_layers && levels == m_levels) return m_values;
    m_layers = layers;
    m_rest = rest;
    m_levels = levels;
    std::vector<float> depths = m_make(layers, *rest);
    lift(*rest, levels, depths);
    m_values = std::make_shared<const std::vector<float>>(std::move(depths));
    m_plan.reset();
    return m_values;
}

std::shared_ptr<const PaintingPlan> CellDepths::plan() {
    if (!m_plan) m_plan = std::make_shared<PaintingPlan>(*m_rest, *m_values);
    return m_plan;
}

}  // namespace wend
