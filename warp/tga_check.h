#pragma once

#include <string>
#include <string_view>

#include "core/mesh/input_file.h"

namespace wend {

/// Whether a file of that size begins as a TGA picture: the format has no mark, so the whole header has to
/// make sense.
bool isTga(std::string_view head, double size);

/// What is wrong with a TGA's palette, empty if nothing: a pixel whose colour it does not hold. Why:
/// OpenImageIO takes such a colour from whatever lies behind the palette in memory.
std::string tgaProblem(const InputFile& file);

}  // namespace wend
