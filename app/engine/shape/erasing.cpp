#include "app/engine/shape/erasing.h"

#include <algorithm>

#include "app/engine/shape/material_raster.h"
#include "app/project/edits/material_edits.h"

namespace wend {

namespace {

constexpr double kUnseen = 0.02;  // of a layer's cover

using Layer = std::span<const MaterialRegion>;

/// Calls with each layer, from the lowest on.
template <class Take>
void forLayers(const Design& design, const Take& take) {
    Layer regions(design.material.regions);
    while (!regions.empty()) {
        const Layer layer = regions.first(layerEnd(regions));
        take(layer);
        regions = regions.subspan(layer.size());
    }
}

bool isHidden(const Layer& layer) {
    return std::ranges::all_of(layer, &MaterialRegion::hidden);
}

template <int Dim>
double distanceOf(const Region<3>& region, const Vec3& p) {
    return signedDistance<Dim>(regionIn<Dim>(region), p.template head<Dim>());
}

/// Returns whether an eraser may overlap a region, including both soft edges.
template <int Dim>
bool mayTouch(const Eraser& eraser, const MaterialRegion& region) {
    if (!eraser.part.empty() && !region.part.empty() && eraser.part != region.part) return false;
    const double soft = (eraser.feather + region.feather) / 2;
    if (const auto* ball = std::get_if<Ball<3>>(&eraser.shape))
        return distanceOf<Dim>(region.shape, ball->centre) <= ball->radius + soft;
    if (const auto* ball = std::get_if<Ball<3>>(&region.shape))
        return distanceOf<Dim>(eraser.shape, ball->centre) <= ball->radius + soft;
    return true;
}

/// Returns whether nothing is left of the region, on any mesh.
template <int Dim>
bool erasesAll(const Eraser& eraser, const MaterialRegion& region) {
    const auto* ball = std::get_if<Ball<3>>(&region.shape);
    if (!ball || eraser.amount < 1 || (!eraser.part.empty() && eraser.part != region.part)) return false;
    const double reach = ball->radius + (region.feather + eraser.feather) / 2;
    return distanceOf<Dim>(eraser.shape, ball->centre) + reach <= 0;
}

/// Returns the layer with erasers on top, without erasers that miss it and without fully erased regions.
template <int Dim>
std::vector<MaterialRegion> erased(const Layer& layer, std::span<const Eraser> erasers,
                                   const SimplicialMesh<Dim>& rest, const std::string& folder) {
    std::vector<MaterialRegion> left;
    for (const auto& region : layer)
        if (std::ranges::none_of(erasers, [&](const auto& one) { return erasesAll<Dim>(one, region); }))
            left.push_back(region);
    const std::vector<MaterialRegion> painted = left;
    std::vector<double> cover;
    for (const Eraser& one : erasers) {
        const auto isUnder = [&](const auto& region) {
            return !region.erases() && mayTouch<Dim>(one, region);
        };
        if (std::ranges::none_of(painted, isUnder)) continue;
        if (one.amount < 1 && cover.empty()) cover = coverOf<Dim>(layer, rest, folder);
        MaterialRegion region{layer.front().name, one.shape, one.feather, {}, {}};
        region.part = one.part;
        region.leaves = one.amount < 1 ? (1 - one.amount) * cover[one.cell] : 0;
        left.push_back(std::move(region));
    }
    if (std::ranges::all_of(left, &MaterialRegion::erases)) left.clear();
    return left;
}

}  // namespace

template <int Dim>
Design withErased(const Design& design, std::span<const Eraser> erasers, const SimplicialMesh<Dim>& rest,
                  const std::string& folder) {
    auto next = design;
    auto& all = next.material.regions;
    all.clear();
    forLayers(design, [&](const Layer& layer) {
        if (isHidden(layer))
            all.insert(all.end(), layer.begin(), layer.end());
        else
            std::ranges::move(erased<Dim>(layer, erasers, rest, folder), std::back_inserter(all));
    });
    return next;
}

template <int Dim>
Design withoutErasedLayers(const Design& design, const SimplicialMesh<Dim>& rest, const std::string& folder) {
    auto next = design;
    auto& all = next.material.regions;
    all.clear();
    forLayers(design, [&](const Layer& layer) {
        const bool isErased = std::ranges::any_of(layer, &MaterialRegion::erases);
        if (isErased && !isHidden(layer) && std::ranges::max(coverOf<Dim>(layer, rest, folder)) < kUnseen)
            return;
        all.insert(all.end(), layer.begin(), layer.end());
    });
    return next;
}

#define WEND_INSTANTIATE(Dim)                                                                           \
    template Design withErased<Dim>(const Design&, std::span<const Eraser>, const SimplicialMesh<Dim>&, \
                                    const std::string&);                                                \
    template Design withoutErasedLayers<Dim>(const Design&, const SimplicialMesh<Dim>&, const std::string&)
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
