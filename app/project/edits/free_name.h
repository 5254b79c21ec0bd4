#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace wend {

/// "KIND 1", or the first number from `first` on that is not taken.
inline std::string freeName(const std::vector<std::string>& taken, const std::string& kind, int first = 1) {
    for (int i = first;; ++i)
        if (const std::string name = kind + ' ' + std::to_string(i); !std::ranges::count(taken, name))
            return name;
}

template <class Things>
std::vector<std::string> namesOf(const Things& things) {
    std::vector<std::string> names;
    for (const auto& thing : things) names.push_back(thing.name);
    return names;
}

/// Groups items of one name, in order of the first of each; items without a name stay separate.
template <class Things>
std::vector<std::vector<int>> placesByName(const Things& things) {
    std::vector<std::vector<int>> groups;
    for (int i = 0; i < static_cast<int>(things.size()); ++i) {
        const std::string& name = things[i].name;
        const auto own = std::ranges::find_if(groups, [&](const std::vector<int>& group) {
            return !name.empty() && things[group.front()].name == name;
        });
        if (own == groups.end())
            groups.push_back({i});
        else
            own->push_back(i);
    }
    return groups;
}

}  // namespace wend
