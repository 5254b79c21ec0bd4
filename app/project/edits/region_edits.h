#pragma once

#include <string>
#include <vector>

#include "app/project/depth_region.h"
#include "app/project/design.h"
#include "app/project/domain.h"

namespace wend {

/// Regions of one name: a stroke, or the surroundings of a pin. Regions without a name stay separate.
struct NamedRegions {
    std::string name;
    double value = 0;                     // of the first: the length of edges against elsewhere, or the order
    std::vector<MaterialRegion> regions;  // their shapes and feathers
};

// The listed regions of a picture: SizeRegion for finer or coarser cells, and DepthRegion.

/// Returns the regions by name; later ones take precedence.
template <class Entry>
std::vector<NamedRegions> namedRegions(const std::vector<Entry>& regions);

/// The group of that place in namedRegions() with another value, with another name (with a number behind it
/// if another or something in `taken` is called so already), or not there any more.
template <class Entry>
std::vector<Entry> withRegionsValue(std::vector<Entry> regions, int group, double value);
template <class Entry>
std::vector<Entry> withRegionsName(std::vector<Entry> regions, int group, const std::string& wish,
                                   std::vector<std::string> taken = {});
template <class Entry>
std::vector<Entry> withoutRegions(std::vector<Entry> regions, int group);

}  // namespace wend
