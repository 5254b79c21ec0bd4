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

}  // namespace wend
