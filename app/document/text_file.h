#pragma once

#include <string>

namespace wend {

/// The whole file; `-` is standard input. Throws InputError(path, why).
std::string readTextFile(const std::string& path);
/// Written whole or not at all. Throws InputError(path, why).
void writeTextFile(const std::string& path, const std::string& text);

}  // namespace wend
