#pragma once

#include <algorithm>
#include <string>

/// JSON in which ' stands for ", for texts that can be read. (Raw strings would do, but moc stumbles over
/// them.)
inline std::string json(std::string text) {
    std::ranges::replace(text, '\'', '"');
    return text;
}
