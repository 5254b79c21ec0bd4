#include "app/project/options/settings.h"

#include <algorithm>

#include "core/energy/material.h"

namespace wend {

double settingOf(const Project& project, std::string_view key) {
    return option(key).field.at.get(project);
}

bool isFor(const Option& setting, const Project& project) {
    return !setting.field.scope || setting.field.scope->holds(project);
}

Range rangeOf(const Option& setting, int dimension) {
    if (setting.kind == OptionKind::Phi) return {0, phi::conformal(dimension), true, false};
    return setting.range;
}

bool sameSettings(const Project& a, const Project& b, Makes makes) {
    return std::ranges::all_of(options(), [&](const Option& one) {
        return !one.field.at.get || one.field.makes != makes || one.field.at.get(a) == one.field.at.get(b);
    });
}

}  // namespace wend
