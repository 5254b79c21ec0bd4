#pragma once

// Which targets Highway compiles kernels for: those of SimdTarget, in every file alike. Include this before
// any header of Highway in a file of kernels. GCC before 12.3 breaks the emulated 128-bit vectors only in the
// high half of a product of integers (GCC bug 106322), which no kernel takes; without the first line Highway
// would take vectors of one number instead.
#define HWY_BROKEN_EMU128 0
#define HWY_DISABLED_TARGETS HWY_AVX3_DL
