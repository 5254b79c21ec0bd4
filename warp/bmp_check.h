#pragma once

#include <string>

#include "core/mesh/input_file.h"

namespace wend {

/// What is wrong with a BMP's header, empty if nothing: one of unknown length, a depth or a way of packing
/// that the format does not have or not together, more colours than the depth can name, pixels without a
/// place in the file. Why: OpenImageIO expands packed pixels as it opens a file, before their size could be
/// looked at, and takes any depth for one that can be packed.
std::string bmpProblem(const InputFile& file);

}  // namespace wend
