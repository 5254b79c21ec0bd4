#include "app/project/edits/material_edits.h"

#include <algorithm>
#include <utility>

namespace wend {

LayerValues valuesOf(const MaterialLayer& layer) {
    LayerValues values;
    bool isFirst = true;
    for (const MaterialRegion& region : layer.regions) {
        if (region.erases()) continue;
        if (std::exchange(isFirst, false)) {
            values.feather = region.feather;
            values.paint = {region.phi, region.stiffness};
            values.pictures = region.pictures;
        }
        if (!region.stiffness) continue;
        if (!values.axis) values.axis = region.stiffness->axis;
        if (*values.axis != region.stiffness->axis || !region.stiffness->wall.empty()) values.oneAxis = false;
    }
    return values;
}

Design withStroke(const Design& design, const PaintedLayer& layer, std::vector<MaterialRegion> regions) {
    Design next = design;
    std::vector<MaterialLayer>& layers = next.material.layers;
    MaterialLayer* own = layerOf(layers, layer.id);
    if (!own) own = &layers.emplace_back(MaterialLayer{layer.name, {}, layer.id});
    std::ranges::move(regions, std::back_inserter(own->regions));
    return next;
}

void setLayerPaint(MaterialLayer& layer, const MaterialPaint& paint, bool keepAxes) {
    for (MaterialRegion& region : layer.regions) {
        if (region.erases()) continue;
        const auto before = std::exchange(region.stiffness, paint.stiffness);
        region.phi = paint.phi;
        if (!(keepAxes && before && region.stiffness)) continue;
        region.stiffness = before;
        region.stiffness->ratio = paint.stiffness->ratio;
    }
}

void setLayerFeather(MaterialLayer& layer, double feather) {
    for (MaterialRegion& region : layer.regions)
        if (!region.erases()) region.feather = feather;
}

void setLayerHidden(MaterialLayer& layer, bool hidden) {
    for (MaterialRegion& region : layer.regions) region.hidden = hidden;
}

void rereadPictures(MaterialLayer& layer) {
    for (MaterialRegion& region : layer.regions) ++region.pictures.readings;
}

Design withPictures(const Design& design, const std::string& name, const Box<2>& box,
                    const MaterialPictures& pictures) {
    Design next = design;
    MaterialRegion region{{Box<3>{inSpace(box.min), inSpace(box.max)}}};
    region.pictures = pictures;
    next.material.layers.push_back(
        {freeLayerName(design.material.layers, Id::None, name), {std::move(region)}});
    return next;
}

std::optional<std::vector<MaterialLayer>> withLayerMergedDown(std::vector<MaterialLayer> layers, Id id) {
    const auto upper = std::ranges::find(layers, id, &MaterialLayer::id);
    if (upper == layers.end() || upper == layers.begin()) return {};
    MaterialLayer& lower = *std::prev(upper);
    const auto shows = [](const MaterialRegion& region) { return region.pictures.any(); };
    if (upper->isHidden() || lower.isHidden() || upper->erases() ||
        std::ranges::any_of(upper->regions, shows) || std::ranges::any_of(lower.regions, shows))
        return {};
    std::ranges::move(upper->regions, std::back_inserter(lower.regions));
    layers.erase(upper);
    keepApart(layers);
    return layers;
}

Design withCellsFile(const Design& design, const std::string& file) {
    auto next = design;
    next.material.cellsFile = file;
    next.material.cellsPhi.clear();
    next.material.cellsB.clear();
    next.material.cellPhi.clear();
    next.material.cellB.clear();
    return next;
}

Design withoutCells(const Design& design) {
    return withCellsFile(design, {});
}

Design withAllHidden(const Design& design) {
    Design next = design;
    for (MaterialLayer& layer : next.material.layers) setLayerHidden(layer, true);
    return next;
}

bool isPainted(const Design& design) {
    return !design.material.cellPhi.empty() ||
           std::ranges::any_of(regionsOf(design.material.layers),
                               [](const MaterialRegion& region) { return !region.hidden; });
}

}  // namespace wend
