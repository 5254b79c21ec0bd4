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
        if (it != groups.end())
            ++it->count;
        else
            groups.push_back({region.name, 1, {region.phi, region.stiffness}});
    }
    return groups;
}

Project withPaint(const Project& project, const std::vector<Ball<3>>& balls, const MaterialPaint& paint) {
    Project next = project;
    const std::string name = freeName(project);
    for (const Ball<3>& ball : balls)
        regionsOf(next).push_back({name, ball, 0.5 * ball.radius, paint.phi, paint.stiffness});
    return next;
}

Project withGroupPaint(const Project& project, const std::string& name, const MaterialPaint& paint) {
    Project next = project;
    for (auto& region : regionsOf(next))
        if (region.name == name) region.phi = paint.phi, region.stiffness = paint.stiffness;
    return next;
}

Project withoutGroup(const Project& project, const std::string& name) {
    Project next = project;
    std::erase_if(regionsOf(next), [&](const auto& region) { return region.name == name; });
    return next;
}

}  // namespace wend
