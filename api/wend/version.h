#pragma once

#include "wend/export.h"

namespace wend {

/// Returns the version of the library that is loaded, such as "0.3.0".
WEND_API const char* version();

}  // namespace wend
