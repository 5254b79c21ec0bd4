#pragma once

#include <string>
#include <string_view>

namespace wend::formats {

/// Encodes bytes as base64. The text has no line ends, and is padded with "=" to a multiple of four
/// characters.
std::string encodeBase64(std::string_view bytes);
/// Decodes base64 up to the padding; blanks are skipped. Throws InputError for anything else.
std::string decodeBase64(std::string_view text);

}  // namespace wend::formats
