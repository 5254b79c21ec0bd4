#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace wend {

/// Returns text from a file in printable form: control characters, bidirectional controls and invalid UTF-8
/// become \x1b or \u{202e}; line ends become blanks. Printable text is unchanged.
std::string printable(std::string_view text);
/// Returns the message with its plain texts in printable form.
Message printableMessage(const Message& message);

/// Returns "FILE: what is wrong" as one printable line; what() would end at the first NUL.
Message messageOf(const std::exception& error);

}  // namespace wend
