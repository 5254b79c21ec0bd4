#pragma once

#include <string>

#include "core/mesh/input_file.h"

namespace wend {

/// What is wrong with a PNG's structure, empty if nothing: a chunk that is cut off, damaged (its checksum
/// does not fit), unknown but needed, or out of place; a header that makes no sense; more pixels than can
/// come out of so little data; pixels whose compression is damaged (in files of moderate size: to expand the
/// data of larger ones would take as long again as to read them). Why: libpng prints a line of its own for
/// each of these, and allocation goes by what a 74-byte file may claim.
std::string pngProblem(const InputFile& file);

}  // namespace wend
