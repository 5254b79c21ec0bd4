#pragma once

#include <string>
#include <string_view>

#include "core/mesh/error.h"

namespace wend {

/// Text that may come from a file, as it can be shown to people and terminals: control characters, those that
/// turn the direction of writing and bytes that are no UTF-8 stand as \x1b or \u{202e}; line ends become
/// blanks. What is printable already stays as it is.
std::string printable(std::string_view text);

/// "FILE: what is wrong" as one printable line; what() would end at the first NUL.
std::string messageOf(const std::exception& error);

}  // namespace wend
