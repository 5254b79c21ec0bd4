#include "app/project/edits/region_edits.h"

#include <algorithm>

#include "app/project/edits/free_name.h"

namespace wend {

namespace {

auto& valueOf(auto& region) {
    if constexpr (requires { region.factor; })
        return region.factor;
    else
        return region.order;
}

MaterialRegion placeOf(const SizeRegion& region) {
    return {region.name, region.shape, region.feather, {}, {}};
}
MaterialRegion placeOf(const DepthRegion& region) {
    return {region.name, region.shape, 0, {}, {}};
}

/// Returns the indices of a group's entries; none if there is no such group.
template <class Entry>
std::vector<int> placesIn(const std::vector<Entry>& regions, int group) {
    const auto groups = placesByName(regions);
    return group >= 0 && group < static_cast<int>(groups.size()) ? groups[group] : std::vector<int>();
}

}  // namespace

template <class Entry>
std::vector<NamedRegions> namedRegions(const std::vector<Entry>& regions) {
    std::vector<NamedRegions> groups;
    for (const std::vector<int>& places : placesByName(regions)) {
        const Entry& first = regions[places.front()];
        NamedRegions& group = groups.emplace_back(NamedRegions{first.name, valueOf(first), {}});
        for (const int i : places) group.regions.push_back(placeOf(regions[i]));
    }
    return groups;
}

template <class Entry>
std::vector<Entry> withRegionsValue(std::vector<Entry> regions, int group, double value) {
    for (const int i : placesIn(regions, group)) valueOf(regions[i]) = value;
    return regions;
}

template <class Entry>
std::vector<Entry> withRegionsName(std::vector<Entry> regions, int group, const std::string& wish,
                                   std::vector<std::string> taken) {
    const std::vector<int> places = placesIn(regions, group);
    if (places.empty()) return regions;
    for (const std::string& name : namesOf(regions)) taken.push_back(name);
    std::erase(taken, regions[places.front()].name);
    const std::string name = std::ranges::count(taken, wish) ? freeName(taken, wish, 2) : wish;
    for (const int i : places) regions[i].name = name;
    return regions;
}

template <class Entry>
std::vector<Entry> withoutRegions(std::vector<Entry> regions, int group) {
    const std::vector<int> places = placesIn(regions, group);
    for (auto i = places.rbegin(); i != places.rend(); ++i) regions.erase(regions.begin() + *i);
    return regions;
}

#define WEND_INSTANTIATE(Entry)                                                              \
    template std::vector<NamedRegions> namedRegions(const std::vector<Entry>&);              \
    template std::vector<Entry> withRegionsValue(std::vector<Entry>, int, double);           \
    template std::vector<Entry> withRegionsName(std::vector<Entry>, int, const std::string&, \
                                                std::vector<std::string>);                   \
    template std::vector<Entry> withoutRegions(std::vector<Entry>, int)

WEND_INSTANTIATE(SizeRegion);
WEND_INSTANTIATE(DepthRegion);
#undef WEND_INSTANTIATE

}  // namespace wend
