#pragma once

#include <string>
#include <vector>

#include "app/project/domain.h"

namespace wend {

/// Size regions of one name: a stroke. Regions without a name stay separate.
struct SizeGroup {
    std::string name;
    std::vector<int> entries;  // of domain.sizes
    SizeRegion first;
};
std::vector<SizeGroup> sizeGroups(const Domain& domain);

/// Soft balls (feathered by half of their radius) on top of all others, named "Stroke 1", "Stroke 2" …
Domain withSizeStroke(const Domain& domain, const std::vector<Ball<3>>& balls, double factor);
/// Adds a stroke in a picture, or in one of its parts, with that feather, and removes strokes that it covers
/// completely.
Domain withFlatSizeStroke(const Domain& domain, const std::vector<Ball<3>>& balls, double feather,
                          double factor, const std::string& part = {});
/// Adds a region on top of all others, named "Region 1", "Region 2" …
Domain withSizeRegion(const Domain& domain, const Region<3>& shape, double factor);
/// Return the domain with another factor for the group at that place in sizeGroups(), or with another shape
/// for the first region of it.
Domain withSizeFactor(const Domain& domain, int group, double factor);
Domain withSizeShape(const Domain& domain, int group, const Region<3>& shape, double feather);
Domain withoutSizes(const Domain& domain, int group);

}  // namespace wend
