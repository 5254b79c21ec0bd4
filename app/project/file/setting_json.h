#pragma once

#include "app/project/file/json_reader.h"

namespace wend {

struct Project;

/// Names of the steps of a repair, in the order of SurfaceFix::Kind.
inline const std::vector<std::string> kFixWords{"fill", "drop", "turn"};

/// Reads the settings of the table in this object, "domain.outline", as far as the project is known to have
/// them.
void readSettings(JsonObject& object, std::string_view group, Project& project);
/// Writes them: all that are always written, and those that are not at their default.
void writeSettings(nlohmann::ordered_json& json, std::string_view group, const Project& project);

/// Reads a name or a number in the range of that dimension.
double readPhi(const JsonValue& value, int dim);
nlohmann::ordered_json phiJson(double phi, int dim);
/// Throws InputError for numbers that JSON cannot represent.
nlohmann::ordered_json numberJson(double value);

/// Returns the option's word for a value.
template <class Enum>
std::string wordOf(std::string_view optionKey, Enum value) {
    return choicesOf(option(optionKey)).at(static_cast<std::size_t>(value));
}

}  // namespace wend
