#include "app/project/file/setting_json.h"

#include <cmath>
#include <limits>

#include "app/project/options/settings.h"
#include "app/project/project_fwd.h"
#include "core/base/error.h"
#include "core/energy/material.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the last part of the option's key if it belongs to that group.
std::optional<std::string> nameIn(std::string_view group, const Option& option) {
    const auto dot = option.key.rfind('.');
    if (!option.field.at.get || option.field.inFile == InFile::ByHand || option.key.substr(0, dot) != group)
        return std::nullopt;
    return std::string(option.key.substr(dot + 1));
}

double valueFrom(const JsonValue& value, const Option& option, int dim) {
    if (option.kind == OptionKind::Flag) return value.boolean();
    if (option.kind == OptionKind::Integer) return value.integer(option.key);
    if (option.kind == OptionKind::Choice) return value.choice<int>(option.key);
    if (option.kind == OptionKind::Unbounded && value.json().is_string()) {
        if (isChoice(option, value.text())) return std::numeric_limits<double>::infinity();
        value.fail("is neither a number nor \"" + std::string(option.choices) + "\"");
    }
    return option.kind == OptionKind::Phi ? readPhi(value, dim) : value.number(option.key);
}

Json jsonOf(double value, const Option& option, int dim) {
    if (option.kind == OptionKind::Flag) return value != 0;
    if (option.kind == OptionKind::Integer) return static_cast<int>(value);
    if (option.kind == OptionKind::Choice) return wordOf(option.key, value);
    if (option.kind == OptionKind::Unbounded && std::isinf(value)) return textOf(option, value);
    return option.kind == OptionKind::Phi ? phiJson(value, dim) : numberJson(value);
}

}  // namespace

void readSettings(JsonObject& object, std::string_view group, Project& project) {
    for (const Option& one : options())
        if (const auto name = nameIn(group, one); name && isFor(one, project))
            if (const auto value = object.find(*name))
                one.field.at.set(project, valueFrom(*value, one, dimensionOf(project)));
}

void writeSettings(Json& json, std::string_view group, const Project& project) {
    for (const Option& one : options()) {
        const auto name = nameIn(group, one);
        if (!name || !isFor(one, project)) continue;
        const double value = one.field.at.get(project);
        if (one.field.inFile == InFile::Always || value != defaultOf(one))
            json[*name] = jsonOf(value, one, dimensionOf(project));
    }
}

double readPhi(const JsonValue& value, int dim) {
    double number = 0;
    if (value.json().is_string()) {
        number = phiOfName(value.text(), dim);
        if (std::isnan(number))
            value.fail("unknown name \"" + value.text() + "\"; known are equia, metr, akvf, conf");
    } else {
        number = value.number();
    }
    if (const std::string problem = phi::problem(number, dim); !problem.empty()) value.fail(problem);
    return number;
}

Json phiJson(double phi, int dim) {
    const std::string name = nameOfPhi(phi, dim);
    return name.empty() ? numberJson(phi) : Json(name);
}

Json numberJson(double value) {
    if (!std::isfinite(value)) throw InputError("a number is not finite and cannot be written");
    return value;
}

}  // namespace wend
