#pragma once

#include <string_view>

namespace wend {

/// Returns the text of an embedded kernel file such as "assembly.cl"; empty if there is none of that name.
std::string_view kernelSource(std::string_view name);

}  // namespace wend
