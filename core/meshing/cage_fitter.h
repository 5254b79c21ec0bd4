#pragma once

#include "core/meshing/cage.h"

namespace wend {

/// fitCage, in this process: what wend-cage does. Throws InputError; Cancelled; std::bad_alloc.
Cage cageAround(const Surface& surface, const CageOptions& options);

}  // namespace wend
