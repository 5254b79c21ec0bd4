#include "app/engine/shape/erasing.h"

#include <algorithm>

#include "app/engine/shape/material_raster.h"

namespace wend {

namespace {

constexpr double kUnseen = 0.02;  // of a layer's cover

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

/// Returns the regions of a layer with erasers on top, without erasers that miss it and without fully erased
/// regions.
template <int Dim>
std::vector<MaterialRegion> erased(const MaterialLayer& layer, std::span<const Eraser> erasers,
                                   const SimplicialMesh<Dim>& rest, const std::string& folder) {
    std::vector<MaterialRegion> left;
    for (const MaterialRegion& region : layer.regions)
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
        MaterialRegion region{{one.shape, one.feather, one.part}};
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
    Design next = design;
    for (MaterialLayer& layer : next.material.layers)
        if (!layer.isHidden()) layer.regions = erased<Dim>(layer, erasers, rest, folder);
    std::erase_if(next.material.layers, [](const MaterialLayer& layer) { return layer.regions.empty(); });
    return next;
}

template <int Dim>
Design withoutErasedLayers(const Design& design, const SimplicialMesh<Dim>& rest, const std::string& folder) {
    Design next = design;
    std::erase_if(next.material.layers, [&](const MaterialLayer& layer) {
        return layer.erases() && !layer.isHidden() &&
               std::ranges::max(coverOf<Dim>(layer, rest, folder)) < kUnseen;
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
