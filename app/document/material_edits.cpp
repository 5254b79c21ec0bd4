#include "app/document/material_edits.h"

#include <algorithm>

namespace wend {

namespace {

std::vector<MaterialRegion<3>>& regionsOf(Project& project) {
    return std::get<Design<3>>(project.design).material.regions;
}

std::string freeName(const Project& project) {
    const auto groups = regionGroups(project);
    for (int i = 1;; ++i) {
        const std::string name = "Stroke " + std::to_string(i);
        if (std::none_of(groups.begin(), groups.end(), [&](const auto& g) { return g.name == name; }))
            return name;
    }
}

}  // namespace

std::vector<RegionGroup> regionGroups(const Project& project) {
    std::vector<RegionGroup> groups;
    for (const auto& region : std::get<Design<3>>(project.design).material.regions) {
        const auto it =
            std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.name == region.name; });
        if (it != groups.end()) {
            ++it->count;
            if (!region.stiffness) continue;
            if (!it->axis) it->axis = region.stiffness->axis;
            if (*it->axis != region.stiffness->axis) it->oneAxis = false;
        } else {
            groups.push_back({region.name, 1, {region.phi, region.stiffness}, {}});
            if (region.stiffness) groups.back().axis = region.stiffness->axis;
        }
    }
    return groups;
}

Project withPaint(const Project& project, const std::vector<Ball<3>>& balls, const MaterialPaint& paint,
                  const std::vector<Vec<3>>& axes) {
    Project next = project;
    const std::string name = freeName(project);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        auto stiffness = paint.stiffness;
        if (stiffness && i < axes.size() && axes[i].norm() > 0) stiffness->axis = axes[i].normalized();
        regionsOf(next).push_back({name, balls[i], 0.5 * balls[i].radius, paint.phi, stiffness});
    }
    return next;
}

Project withGroupPaint(const Project& project, const std::string& name, const MaterialPaint& paint,
                       bool keepAxes) {
    Project next = project;
    for (auto& region : regionsOf(next)) {
        if (region.name != name) continue;
        const auto before = region.stiffness;
        region.phi = paint.phi;
        region.stiffness = paint.stiffness;
        if (keepAxes && before && region.stiffness) region.stiffness->axis = before->axis;
    }
    return next;
}

Project withoutGroup(const Project& project, const std::string& name) {
    Project next = project;
    std::erase_if(regionsOf(next), [&](const auto& region) { return region.name == name; });
    return next;
}

}  // namespace wend
