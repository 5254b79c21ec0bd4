#include "app/project/edits/material_edits.h"

#include <algorithm>

#include "app/project/edits/free_name.h"

namespace wend {

namespace {

/// Returns the design after a change of the material's regions.
template <class Change>
Design changed(const Design& design, const Change& change) {
    Design next = design;
    change(next.material.regions);
    return next;
}

/// Returns the names of the groups in the order of their first regions.
std::vector<std::string> groupNames(const Design& design) {
    std::vector<std::string> names;
    for (const auto& region : design.material.regions)
        if (std::find(names.begin(), names.end(), region.name) == names.end()) names.push_back(region.name);
    return names;
}

}  // namespace

std::vector<RegionGroup> regionGroups(const Design& design) {
    std::vector<RegionGroup> groups;
    for (const auto& region : design.material.regions) {
        auto it =
            std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.name == region.name; });
        if (it == groups.end()) it = groups.insert(it, {.name = region.name});
        it->hidden = it->hidden || region.hidden;
        if (region.erases()) continue;
        if (it->count++ == 0) {
            it->feather = region.feather;
            it->paint = {region.phi, region.stiffness};
            it->pictures = region.pictures;
        }
        if (!region.stiffness) continue;
        if (!it->axis) it->axis = region.stiffness->axis;
        if (*it->axis != region.stiffness->axis || !region.stiffness->wall.empty()) it->oneAxis = false;
    }
    return groups;
}

std::size_t layerEnd(std::span<const MaterialRegion> regions) {
    const auto other = std::ranges::find_if(
        regions, [&](const auto& region) { return region.name != regions.front().name; });
    return static_cast<std::size_t>(other - regions.begin());
}

std::size_t layerBegin(const Design& design, const std::string& name) {
    const auto& all = design.material.regions;
    std::size_t at = all.size();
    while (at > 0 && all[at - 1].name != name) --at;
    if (at == 0) return all.size();
    while (at > 0 && all[at - 1].name == name) --at;
    return at;
}

Design withStroke(const Design& design, const std::string& layer, std::vector<MaterialRegion> regions) {
    auto next = design;
    auto& all = next.material.regions;
    const std::span<const MaterialRegion> upper = std::span(all).subspan(layerBegin(design, layer));
    auto at = all.end() - std::ssize(upper) + (upper.empty() ? 0 : std::ptrdiff_t(layerEnd(upper)));
    for (auto& region : regions) {
        region.name = layer;
        at = std::next(all.insert(at, std::move(region)));
    }
    return next;
}

Design withGroupPaint(const Design& design, const std::string& name, const MaterialPaint& paint,
                      bool keepAxes) {
    auto next = design;
    for (auto& region : next.material.regions) {
        if (region.name != name || region.erases()) continue;
        const auto before = region.stiffness;
        region.phi = paint.phi;
        region.stiffness = paint.stiffness;
        if (!(keepAxes && before && region.stiffness)) continue;
        const double ratio = region.stiffness->ratio;
        region.stiffness = before;
        region.stiffness->ratio = ratio;
    }
    return next;
}

Design withGroupFeather(const Design& design, const std::string& name, double feather) {
    return changed(design, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name && !region.erases()) region.feather = feather;
    });
}

bool isGroupHidden(const Design& design, const std::string& name) {
    return std::ranges::any_of(design.material.regions, [&](const MaterialRegion& region) {
        return region.name == name && region.hidden;
    });
}

Design withGroupHidden(const Design& design, const std::string& name, bool hidden) {
    return changed(design, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) region.hidden = hidden;
    });
}

Design withPictures(const Design& design, const std::string& name, const Box<2>& box,
                    const MaterialPictures& pictures) {
    auto next = design;
    MaterialRegion region;
    region.name = freeGroupName(design, {}, name);
    region.shape = Box<3>{inSpace(box.min), inSpace(box.max)};
    region.pictures = pictures;
    next.material.regions.push_back(std::move(region));
    return next;
}

Design withPicturesReread(const Design& design, const std::string& name) {
    return changed(design, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) ++region.pictures.readings;
    });
}

std::string freeGroupName(const Design& design, const std::string& name, const std::string& wish) {
    std::vector<std::string> taken = groupNames(design);
    std::erase(taken, name);
    const bool isTaken = std::find(taken.begin(), taken.end(), wish) != taken.end();
    return isTaken ? freeName(taken, wish, 2) : wish;
}

Design withGroupName(const Design& design, const std::string& name, const std::string& next) {
    const std::string free = freeGroupName(design, name, next);
    return changed(design, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) region.name = free;
    });
}

Design withGroupMoved(const Design& design, const std::string& name, int by) {
    std::vector<std::string> order = groupNames(design);
    const auto it = std::find(order.begin(), order.end(), name);
    if (it == order.end()) return design;
    const auto from = it - order.begin();
    const auto to = std::clamp<std::ptrdiff_t>(from + by, 0, std::ssize(order) - 1);
    order.erase(it);
    order.insert(order.begin() + to, name);
    const auto placeOf = [&](const std::string& group) {
        return std::find(order.begin(), order.end(), group) - order.begin();
    };
    return changed(design, [&](auto& regions) {
        std::stable_sort(regions.begin(), regions.end(),
                         [&](const auto& a, const auto& b) { return placeOf(a.name) < placeOf(b.name); });
    });
}

std::optional<Design> withGroupMergedDown(const Design& design, const std::string& name) {
    const std::vector<std::string> order = groupNames(design);
    const auto upper = std::ranges::find(order, name);
    if (upper == order.end() || upper == order.begin()) return {};
    const std::string lower = *std::prev(upper);
    bool differs = isGroupHidden(design, name) || isGroupHidden(design, lower);
    auto next = changed(withGroupMoved(design, name, 0), [&](auto& regions) {
        for (auto& region : regions) {
            if (region.name != name && region.name != lower) continue;
            differs = differs || region.pictures.any() || (region.name == name && region.erases());
            region.name = lower;
        }
    });
    return differs ? std::nullopt : std::optional(std::move(next));
}

Design withoutGroup(const Design& design, const std::string& name) {
    return changed(design, [&](auto& regions) {
        std::erase_if(regions, [&](const auto& region) { return region.name == name; });
    });
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
    return changed(design, [](auto& regions) {
        for (auto& region : regions) region.hidden = true;
    });
}

bool isPainted(const Design& design) {
    return !design.material.cellPhi.empty() ||
           std::ranges::any_of(design.material.regions,
                               [](const MaterialRegion& region) { return !region.hidden; });
}

}  // namespace wend
