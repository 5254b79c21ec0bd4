#pragma once

#include <algorithm>
#include <string>

/// Converts ' to " in JSON, so that the texts are readable. (moc cannot parse raw strings.)
inline std::string json(std::string text) {
    std::ranges::replace(text, '\'', '"');
    return text;
}
