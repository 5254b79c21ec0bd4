#pragma once

#include "core/base/highway_targets.h"

// Spans have vectors of four and of eight floats: SSSE3 brings them nothing over the emulated vectors, which
// run in its place. Each target takes 2 s a type of number to compile.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SSSE3)
