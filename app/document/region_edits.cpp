#include "app/document/region_edits.h"

#include <algorithm>

#include "app/document/free_name.h"

namespace wend {

namespace {

double& valueOf(SizeRegionIn<2>& region) {
    return region.factor;
}
double& valueOf(DepthRegion& region) {
    return region.order;
}

MaterialRegion<2> placeOf(const SizeRegionIn<2>& region) {
    return {region.name, region.shape, region.feather, {}, {}};
}
MaterialRegion<2> placeOf(const DepthRegion& region) {
    return {region.name, region.shape, 0, {}, {}};
}

template <class Entries>
std::vector<NamedRegions> groupsOf(Entries entries) {
    std::vector<NamedRegions> groups;
    for (const std::vector<int>& places : placesByName(entries)) {
        auto& first = entries[places.front()];
        NamedRegions& group = groups.emplace_back(NamedRegions{first.name, valueOf(first), {}});
        for (const int i : places) group.regions.push_back(placeOf(entries[i]));
    }
    return groups;
}

/// Does something with all regions of that kind, and with the places of a group among them.
template <class Change>
Project changed(const Project& project, RegionsOf of, int group, const Change& change) {
    Project next = project;
    const auto on = [&](auto& entries) {
        const auto groups = placesByName(entries);
        if (group >= 0 && group < static_cast<int>(groups.size())) change(entries, groups[group]);
    };
    of == RegionsOf::Detail ? on(next.domain.flatSizes) : on(next.depth);
    return next;
}

}  // namespace

std::vector<NamedRegions> namedRegions(const Project& project, RegionsOf of) {
    return of == RegionsOf::Detail ? groupsOf(project.domain.flatSizes) : groupsOf(project.depth);
}

Project withRegionsValue(const Project& project, RegionsOf of, int group, double value) {
    return changed(project, of, group, [&](auto& entries, const std::vector<int>& places) {
        for (const int i : places) valueOf(entries[i]) = value;
    });
}

Project withRegionsName(const Project& project, RegionsOf of, int group, const std::string& wish) {
    const std::string before = namedRegions(project, of).at(group).name;
    std::vector<Handle<2>> handles = std::get<Design<2>>(project.design).handles;
    Project next = changed(project, of, group, [&](auto& entries, const std::vector<int>& places) {
        auto taken = namesOf(entries);
        if (of == RegionsOf::Depth)
            for (const Handle<2>& handle : handles) taken.push_back(handle.name);
        std::erase(taken, before);
        const std::string name = std::ranges::count(taken, wish) ? freeName(taken, wish, 2) : wish;
        for (const int i : places) entries[i].name = name;
        for (Handle<2>& handle : handles)
            if (!before.empty() && handle.name == before) handle.name = name;
    });
    if (of == RegionsOf::Depth) std::get<Design<2>>(next.design).handles = std::move(handles);
    return next;
}

Project withoutRegions(const Project& project, RegionsOf of, int group) {
    return changed(project, of, group, [](auto& entries, const std::vector<int>& places) {
        for (auto i = places.rbegin(); i != places.rend(); ++i) entries.erase(entries.begin() + *i);
    });
}

}  // namespace wend
