#pragma once

#include <string>

#include "core/base/input_file.h"

namespace wend {

/// Returns what is wrong with a PNG's structure, or an empty string: a truncated, damaged (wrong checksum),
/// unknown critical or misplaced chunk; an invalid header; more pixels than the data can encode; damaged
/// compression (in files of moderate size: checking larger ones would take as long as reading them).
/// Necessary because libpng prints messages for these, and allocates by what a 74-byte file claims.
std::string pngProblem(const InputFile& file);

}  // namespace wend
