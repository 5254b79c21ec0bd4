#pragma once

#include <string>
#include <string_view>

namespace wend::formats {

std::string encodeBase64(std::string_view bytes);
/// Stops at padding; blanks are passed over. Throws InputError for anything that is not base64.
std::string decodeBase64(std::string_view text);

}  // namespace wend::formats
