#pragma once

#include <string>

#include "core/base/input_file.h"

namespace wend {

/// Returns what is wrong with a BMP's header, or an empty string: an unknown length, a depth or packing that
/// the format does not have, too many colours for the depth, pixels outside the file. Necessary because
/// OpenImageIO expands packed pixels when it opens a file, before their size could be checked, and accepts
/// packing with any depth.
std::string bmpProblem(const InputFile& file);

}  // namespace wend
