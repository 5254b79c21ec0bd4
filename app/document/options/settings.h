#pragma once

#include "app/document/options/options.h"

namespace wend {

/// The value in this project; the key must be that of a setting with a field.
double settingOf(const Project& project, std::string_view key);

/// True if such a project has the setting.
bool isFor(const Option& setting, const Project& project);

/// What the value may be in a project of that dimension, which says where φ ends.
Range rangeOf(const Option& setting, int dimension);

/// True if all settings that make this anew are the same in both.
bool sameSettings(const Project& a, const Project& b, Makes makes);

}  // namespace wend
