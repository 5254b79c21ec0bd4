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
/// What the stiff direction of a stroke is: an axis of the rest shape, the direction of view, the stroke's
/// own way, or the way of the selected handle.
enum class StiffAlong { Axis, View, Stroke, Way };

/// Regions of one name belong together: a stroke, or one that was read.
struct RegionGroup {
    std::string name;
    int count = 0;
    MaterialPaint paint;         // of the first
    std::optional<Vec<3>> axis;  // of the first that is stiff
    bool oneAxis = true;         // all that are stiff are so along it
};
std::vector<RegionGroup> regionGroups(const Project& project);

/// Soft balls (feathered by half of their radius) on top of all regions, named "Stroke 1", "Stroke 2" …
/// `axes`: of each ball, in place of the paint's; may be empty.
Project withPaint(const Project& project, const std::vector<Ball<3>>& balls, const MaterialPaint& paint,
                  const std::vector<Vec<3>>& axes = {});
/// The group of that name with another material; `keepAxes`: what is stiff stays so along its own direction.
Project withGroupPaint(const Project& project, const std::string& name, const MaterialPaint& paint,
                       bool keepAxes = false);
/// The group without its regions.
Project withoutGroup(const Project& project, const std::string& name);

}  // namespace wend
