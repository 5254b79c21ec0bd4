#pragma once

#include <string>
#include <string_view>

#include "core/base/input_file.h"

namespace wend {

/// Returns whether a file of that size starts as a TGA picture: the format has no signature, so the whole
/// header must be plausible.
bool isTga(std::string_view head, double size);

/// Returns what is wrong with a TGA's palette, or an empty string: a pixel index outside of it. Necessary
/// because OpenImageIO reads such colours out of bounds.
std::string tgaProblem(const InputFile& file);

}  // namespace wend
