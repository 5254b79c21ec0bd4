#include "app/project/edits/material_edits.h"

#include <algorithm>

#include "app/project/edits/free_name.h"

namespace wend {

namespace {

/// Calls with the material's regions of either dimension.
template <class Change>
AnyDesign changed(const AnyDesign& design, const Change& change) {
    auto next = design;
    std::visit([&](auto& own) { change(own.material.regions); }, next);
    return next;
}

/// Returns the names of the groups in the order of their first regions.
template <int Dim>
std::vector<std::string> groupNames(const Design<Dim>& design) {
    std::vector<std::string> names;
    for (const auto& region : design.material.regions)
        if (std::find(names.begin(), names.end(), region.name) == names.end()) names.push_back(region.name);
    return names;
}
std::vector<std::string> groupNames(const AnyDesign& design) {
    return std::visit([](const auto& own) { return groupNames(own); }, design);
}

}  // namespace

template <int Dim>
std::vector<RegionGroup<Dim>> regionGroups(const Design<Dim>& design) {
    std::vector<RegionGroup<Dim>> groups;
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

template <int Dim>
std::size_t layerEnd(std::span<const MaterialRegion<Dim>> regions) {
    const auto other = std::ranges::find_if(
        regions, [&](const auto& region) { return region.name != regions.front().name; });
    return static_cast<std::size_t>(other - regions.begin());
}

template <int Dim>
std::size_t layerBegin(const Design<Dim>& design, const std::string& name) {
    const auto& all = design.material.regions;
    std::size_t at = all.size();
    while (at > 0 && all[at - 1].name != name) --at;
    if (at == 0) return all.size();
    while (at > 0 && all[at - 1].name == name) --at;
    return at;
}

template <int Dim>
Design<Dim> withStroke(const Design<Dim>& design, const std::string& layer,
                       std::vector<MaterialRegion<Dim>> regions) {
    auto next = design;
    auto& all = next.material.regions;
    const std::span<const MaterialRegion<Dim>> upper = std::span(all).subspan(layerBegin(design, layer));
    auto at = all.end() - std::ssize(upper) + (upper.empty() ? 0 : std::ptrdiff_t(layerEnd<Dim>(upper)));
    for (auto& region : regions) {
        region.name = layer;
        at = std::next(all.insert(at, std::move(region)));
    }
    return next;
}

template <int Dim>
Design<Dim> withGroupPaint(const Design<Dim>& design, const std::string& name,
                           const MaterialPaint<Dim>& paint, bool keepAxes) {
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

AnyDesign withGroupFeather(const AnyDesign& design, const std::string& name, double feather) {
    return changed(design, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name && !region.erases()) region.feather = feather;
    });
}

bool isGroupHidden(const AnyDesign& design, const std::string& name) {
    return std::visit(
        [&](const auto& own) {
            const auto& regions = own.material.regions;
            return std::any_of(regions.begin(), regions.end(),
                               [&](const auto& region) { return region.name == name && region.hidden; });
        },
        design);
}

AnyDesign withGroupHidden(const AnyDesign& design, const std::string& name, bool hidden) {
    return changed(design, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) region.hidden = hidden;
    });
}

AnyDesign withPictures(const AnyDesign& design, const std::string& name, const Box<2>& box,
                       const MaterialPictures& pictures) {
    auto next = design;
    MaterialRegion<2> region;
    region.name = freeGroupName(design, {}, name);
    region.shape = box;
    region.pictures = pictures;
    std::get<Design<2>>(next).material.regions.push_back(std::move(region));
    return next;
}

AnyDesign withPicturesReread(const AnyDesign& design, const std::string& name) {
    return changed(design, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) ++region.pictures.readings;
    });
}

std::string freeGroupName(const AnyDesign& design, const std::string& name, const std::string& wish) {
    std::vector<std::string> taken = groupNames(design);
    std::erase(taken, name);
    const bool isTaken = std::find(taken.begin(), taken.end(), wish) != taken.end();
    return isTaken ? freeName(taken, wish, 2) : wish;
}

AnyDesign withGroupName(const AnyDesign& design, const std::string& name, const std::string& next) {
    const std::string free = freeGroupName(design, name, next);
    return changed(design, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) region.name = free;
    });
}

AnyDesign withGroupMoved(const AnyDesign& design, const std::string& name, int by) {
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

std::optional<AnyDesign> withGroupMergedDown(const AnyDesign& design, const std::string& name) {
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

AnyDesign withoutGroup(const AnyDesign& design, const std::string& name) {
    return changed(design, [&](auto& regions) {
        std::erase_if(regions, [&](const auto& region) { return region.name == name; });
    });
}

AnyDesign withCellsFile(const AnyDesign& design, const std::string& file) {
    auto next = design;
    std::visit(
        [&](auto& own) {
            own.material.cellsFile = file;
            own.material.cellsPhi.clear();
            own.material.cellsB.clear();
            own.material.cellPhi.clear();
            own.material.cellB.clear();
        },
        next);
    return next;
}

AnyDesign withoutCells(const AnyDesign& design) {
    return withCellsFile(design, {});
}

AnyDesign withAllHidden(const AnyDesign& design) {
    return changed(design, [](auto& regions) {
        for (auto& region : regions) region.hidden = true;
    });
}

bool isPainted(const AnyDesign& design) {
    return std::visit(
        [](const auto& one) {
            const auto& [regions, cells] = std::tie(one.material.regions, one.material.cellPhi);
            return !cells.empty() ||
                   std::ranges::any_of(regions, [](const auto& region) { return !region.hidden; });
        },
        design);
}

#define WEND_INSTANTIATE(Dim)                                                        \
    template std::size_t layerEnd<Dim>(std::span<const MaterialRegion<Dim>>);        \
    template std::size_t layerBegin<Dim>(const Design<Dim>&, const std::string&);    \
    template Design<Dim> withStroke<Dim>(const Design<Dim>&, const std::string&,     \
                                         std::vector<MaterialRegion<Dim>>);          \
    template std::vector<RegionGroup<Dim>> regionGroups<Dim>(const Design<Dim>&);    \
    template Design<Dim> withGroupPaint<Dim>(const Design<Dim>&, const std::string&, \
                                             const MaterialPaint<Dim>&, bool)
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
