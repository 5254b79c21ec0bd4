#pragma once

#include <string>

#include "core/base/file_access.h"

namespace wend {

/// Returns the whole file; `-` is standard input. Throws InputError(path, why).
std::string readTextFile(const std::string& path);
/// Written whole or not at all. Throws InputError(path, why).
void writeTextFile(const std::string& path, const std::string& text, Access access = Access::Usual);

}  // namespace wend
