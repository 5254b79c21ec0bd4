#pragma once

#include "app/project/options/options.h"

namespace wend {

/// Returns the value in this project; the key must be that of a setting with a field.
double settingOf(const Project& project, std::string_view key);

/// Returns whether such a project has the setting.
bool isFor(const Option& setting, const Project& project);

/// Returns the range in a project of that dimension, which limits φ.
Range rangeOf(const Option& setting, int dimension);

/// Returns whether all settings that invalidate this stage are equal in both.
bool sameSettings(const Project& a, const Project& b, Makes makes);

}  // namespace wend
