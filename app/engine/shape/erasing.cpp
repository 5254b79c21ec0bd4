#include "app/engine/shape/erasing.h"

#include <algorithm>

#include "app/engine/shape/material_raster.h"
#include "app/project/edits/material_edits.h"

namespace wend {

namespace {

constexpr double kUnseen = 0.02;  // of a layer's cover

template <int Dim>
using Layer = std::span<const MaterialRegion<Dim>>;

/// Calls with each layer, from the lowest on.
template <int Dim, class Take>
void forLayers(const Design<Dim>& design, const Take& take) {
    Layer<Dim> regions(design.material.regions);
    while (!regions.empty()) {
        const Layer<Dim> layer = regions.first(layerEnd<Dim>(regions));
        take(layer);
        regions = regions.subspan(layer.size());
    }
}

template <int Dim>
bool isHidden(const Layer<Dim>& layer) {
    return std::ranges::all_of(layer, &MaterialRegion<Dim>::hidden);
}

/// Returns whether an eraser may overlap a region, including both soft edges.
template <int Dim>
bool mayTouch(const Eraser<Dim>& eraser, const MaterialRegion<Dim>& region) {
    if (!eraser.part.empty() && !region.part.empty() && eraser.part != region.part) return false;
    const double soft = (eraser.feather + region.feather) / 2;
    if (const auto* ball = std::get_if<Ball<Dim>>(&eraser.shape))
        return signedDistance<Dim>(region.shape, ball->centre) <= ball->radius + soft;
    if (const auto* ball = std::get_if<Ball<Dim>>(&region.shape))
        return signedDistance<Dim>(eraser.shape, ball->centre) <= ball->radius + soft;
    return true;
}

/// Returns whether nothing is left of the region, on any mesh.
template <int Dim>
bool erasesAll(const Eraser<Dim>& eraser, const MaterialRegion<Dim>& region) {
    const auto* ball = std::get_if<Ball<Dim>>(&region.shape);
    if (!ball || eraser.amount < 1 || (!eraser.part.empty() && eraser.part != region.part)) return false;
    const double reach = ball->radius + (region.feather + eraser.feather) / 2;
    return signedDistance<Dim>(eraser.shape, ball->centre) + reach <= 0;
}

/// Returns the layer with erasers on top, without erasers that miss it and without fully erased regions.
template <int Dim>
std::vector<MaterialRegion<Dim>> erased(const Layer<Dim>& layer, std::span<const Eraser<Dim>> erasers,
                                        const SimplicialMesh<Dim>& rest, const std::string& folder) {
    std::vector<MaterialRegion<Dim>> left;
    for (const auto& region : layer)
        if (std::ranges::none_of(erasers, [&](const auto& one) { return erasesAll(one, region); }))
            left.push_back(region);
    const std::vector<MaterialRegion<Dim>> painted = left;
    std::vector<double> cover;
    for (const Eraser<Dim>& one : erasers) {
        const auto isUnder = [&](const auto& region) { return !region.erases() && mayTouch(one, region); };
        if (std::ranges::none_of(painted, isUnder)) continue;
        if (one.amount < 1 && cover.empty()) cover = coverOf<Dim>(layer, rest, folder);
        MaterialRegion<Dim> region{layer.front().name, one.shape, one.feather, {}, {}};
        region.part = one.part;
        region.leaves = one.amount < 1 ? (1 - one.amount) * cover[one.cell] : 0;
        left.push_back(std::move(region));
    }
    if (std::ranges::all_of(left, &MaterialRegion<Dim>::erases)) left.clear();
    return left;
}

}  // namespace

template <int Dim>
Design<Dim> withErased(const Design<Dim>& design, std::span<const Eraser<Dim>> erasers,
                       const SimplicialMesh<Dim>& rest, const std::string& folder) {
    auto next = design;
    auto& all = next.material.regions;
    all.clear();
    forLayers(design, [&](const Layer<Dim>& layer) {
        if (isHidden<Dim>(layer))
            all.insert(all.end(), layer.begin(), layer.end());
        else
            std::ranges::move(erased<Dim>(layer, erasers, rest, folder), std::back_inserter(all));
    });
    return next;
}

template <int Dim>
Design<Dim> withoutErasedLayers(const Design<Dim>& design, const SimplicialMesh<Dim>& rest,
                                const std::string& folder) {
    auto next = design;
    auto& all = next.material.regions;
    all.clear();
    forLayers(design, [&](const Layer<Dim>& layer) {
        const bool isErased = std::ranges::any_of(layer, &MaterialRegion<Dim>::erases);
        if (isErased && !isHidden<Dim>(layer) &&
            std::ranges::max(coverOf<Dim>(layer, rest, folder)) < kUnseen)
            return;
        all.insert(all.end(), layer.begin(), layer.end());
    });
    return next;
}

#define WEND_INSTANTIATE(Dim)                                                                     \
    template Design<Dim> withErased<Dim>(const Design<Dim>&, std::span<const Eraser<Dim>>,        \
                                         const SimplicialMesh<Dim>&, const std::string&);         \
    template Design<Dim> withoutErasedLayers<Dim>(const Design<Dim>&, const SimplicialMesh<Dim>&, \
                                                  const std::string&)
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
