#pragma once

#include <string>
#include <vector>

#include "app/document/project.h"

namespace wend {

/// The regions of a picture that are listed: where its mesh is finer or coarser, and what lies in front.
enum class RegionsOf { Detail, Depth };

/// Regions of one name belong together: a stroke, or what lies around a pin. One without a name stands alone.
struct NamedRegions {
    std::string name;
    double value = 0;  // of the first: the length of edges against elsewhere, or the order
    std::vector<MaterialRegion<2>> regions;  // where they lie, and how soft they are
};
/// Later ones win.
std::vector<NamedRegions> namedRegions(const Project& project, RegionsOf of);

/// The group of that place in namedRegions() with another value, with another name (with a number behind it
/// if another is called so already), or not there any more. A handle and the depth that it gives have one
/// name: it is renamed with it.
Project withRegionsValue(const Project& project, RegionsOf of, int group, double value);
Project withRegionsName(const Project& project, RegionsOf of, int group, const std::string& wish);
Project withoutRegions(const Project& project, RegionsOf of, int group);

}  // namespace wend
