#pragma once

#include "core/meshing/cage.h"

namespace wend {

/// Runs fitCage in this process, as wend-cage does. Throws InputError; Cancelled; std::bad_alloc.
Cage cageAround(const Surface& surface, const CageOptions& options);

}  // namespace wend
