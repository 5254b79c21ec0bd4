#include "app/document/material_edits.h"

#include <algorithm>

#include "app/document/free_name.h"
#include "app/document/project.h"

namespace wend {

namespace {

/// Calls with the material's regions of either dimension.
template <class Change>
Project changed(const Project& project, const Change& change) {
    Project next = project;
    std::visit([&](auto& design) { change(design.material.regions); }, next.design);
    return next;
}

/// The names of the groups, in the order of their first regions.
std::vector<std::string> groupNames(const Project& project) {
    std::vector<std::string> names;
    std::visit(
        [&](const auto& design) {
            for (const auto& region : design.material.regions)
                if (std::find(names.begin(), names.end(), region.name) == names.end())
                    names.push_back(region.name);
        },
        project.design);
    return names;
}

}  // namespace

template <int Dim>
std::vector<RegionGroup<Dim>> regionGroups(const Project& project) {
    std::vector<RegionGroup<Dim>> groups;
    for (const auto& region : std::get<Design<Dim>>(project.design).material.regions) {
        auto it =
            std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.name == region.name; });
        if (it == groups.end())
            it = groups.insert(it, {.name = region.name,
                                    .feather = region.feather,
                                    .paint = {region.phi, region.stiffness},
                                    .pictures = region.pictures,
                                    .hidden = region.hidden});
        ++it->count;
        it->hidden = it->hidden || region.hidden;
        if (!region.stiffness) continue;
        if (!it->axis) it->axis = region.stiffness->axis;
        if (*it->axis != region.stiffness->axis) it->oneAxis = false;
    }
    return groups;
}

template <int Dim>
Project withRegions(const Project& project, const std::string& kind,
                    std::vector<MaterialRegion<Dim>> regions) {
    Project next = project;
    const std::string name = freeName(groupNames(project), kind);
    auto& all = std::get<Design<Dim>>(next.design).material.regions;
    for (auto& region : regions) {
        region.name = name;
        all.push_back(std::move(region));
    }
    return next;
}

template <int Dim>
Project withGroupPaint(const Project& project, const std::string& name, const MaterialPaint<Dim>& paint,
                       bool keepAxes) {
    Project next = project;
    for (auto& region : std::get<Design<Dim>>(next.design).material.regions) {
        if (region.name != name) continue;
        const auto before = region.stiffness;
        region.phi = paint.phi;
        region.stiffness = paint.stiffness;
        if (keepAxes && before && region.stiffness) region.stiffness->axis = before->axis;
    }
    return next;
}

Project withGroupFeather(const Project& project, const std::string& name, double feather) {
    return changed(project, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) region.feather = feather;
    });
}

bool isGroupHidden(const Project& project, const std::string& name) {
    return std::visit(
        [&](const auto& design) {
            const auto& regions = design.material.regions;
            return std::any_of(regions.begin(), regions.end(),
                               [&](const auto& region) { return region.name == name && region.hidden; });
        },
        project.design);
}

Project withGroupHidden(const Project& project, const std::string& name, bool hidden) {
    return changed(project, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) region.hidden = hidden;
    });
}

Project withPictures(const Project& project, const std::string& name, const Box<2>& box,
                     const MaterialPictures& pictures) {
    Project next = project;
    MaterialRegion<2> region;
    region.name = freeGroupName(project, {}, name);
    region.shape = box;
    region.pictures = pictures;
    std::get<Design<2>>(next.design).material.regions.push_back(std::move(region));
    return next;
}

Project withPicturesReread(const Project& project, const std::string& name) {
    return changed(project, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) ++region.pictures.readings;
    });
}

std::string freeGroupName(const Project& project, const std::string& name, const std::string& wish) {
    std::vector<std::string> taken = groupNames(project);
    std::erase(taken, name);
    const bool isTaken = std::find(taken.begin(), taken.end(), wish) != taken.end();
    return isTaken ? freeName(taken, wish, 2) : wish;
}

Project withGroupName(const Project& project, const std::string& name, const std::string& next) {
    const std::string free = freeGroupName(project, name, next);
    return changed(project, [&](auto& regions) {
        for (auto& region : regions)
            if (region.name == name) region.name = free;
    });
}

Project withGroupMoved(const Project& project, const std::string& name, int by) {
    std::vector<std::string> order = groupNames(project);
    const auto it = std::find(order.begin(), order.end(), name);
    if (it == order.end()) return project;
    const auto from = it - order.begin();
    const auto to = std::clamp<std::ptrdiff_t>(from + by, 0, std::ssize(order) - 1);
    order.erase(it);
    order.insert(order.begin() + to, name);
    const auto placeOf = [&](const std::string& group) {
        return std::find(order.begin(), order.end(), group) - order.begin();
    };
    return changed(project, [&](auto& regions) {
        std::stable_sort(regions.begin(), regions.end(),
                         [&](const auto& a, const auto& b) { return placeOf(a.name) < placeOf(b.name); });
    });
}

Project withoutGroup(const Project& project, const std::string& name) {
    return changed(project, [&](auto& regions) {
        std::erase_if(regions, [&](const auto& region) { return region.name == name; });
    });
}

Project withCellsFile(const Project& project, const std::string& file) {
    Project next = project;
    std::visit(
        [&](auto& design) {
            design.material.cellsFile = file;
            design.material.cellPhi.clear();
            design.material.cellB.clear();
        },
        next.design);
    return next;
}

Project withoutCells(const Project& project) {
    return withCellsFile(project, {});
}

Project withAllHidden(const Project& project) {
    return changed(project, [](auto& regions) {
        for (auto& region : regions) region.hidden = true;
    });
}

#define WEND_INSTANTIATE(Dim)                                                                                \
    template std::vector<RegionGroup<Dim>> regionGroups<Dim>(const Project&);                                \
    template Project withRegions<Dim>(const Project&, const std::string&, std::vector<MaterialRegion<Dim>>); \
    template Project withGroupPaint<Dim>(const Project&, const std::string&, const MaterialPaint<Dim>&, bool)
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
