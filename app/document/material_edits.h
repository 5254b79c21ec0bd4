#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/project.h"

namespace wend {

/// What a brush lays into a solid.
struct MaterialPaint {
    std::optional<double> phi;
    std::optional<Stiffness<3>> stiffness;
};

/// Regions of one name belong together: a stroke, or one that was read.
struct RegionGroup {
    std::string name;
    int count = 0;
    MaterialPaint paint;  // of the first
};
std::vector<RegionGroup> regionGroups(const Project& project);

/// Soft balls (feathered by half of their radius) on top of all regions, named "Stroke 1", "Stroke 2" …
Project withPaint(const Project& project, const std::vector<Ball<3>>& balls, const MaterialPaint& paint);
/// The groups of that number with another material, or without it.
Project withGroupPaint(const Project& project, const std::string& name, const MaterialPaint& paint);
Project withoutGroup(const Project& project, const std::string& name);

}  // namespace wend
