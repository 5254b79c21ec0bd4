#pragma once

#include <cstdlib>
#include <string_view>

namespace wend {

/// Returns whether the planted fault of that name is switched on, by the environment variable WEND_FAULT.
/// Only the copy of the sources that tests/faults/run makes includes this.
inline bool isFault(std::string_view name) {
    static const char* const on = std::getenv("WEND_FAULT");
    return on != nullptr && name == on;
}

}  // namespace wend
