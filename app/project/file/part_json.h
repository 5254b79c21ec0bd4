#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/project/project_fwd.h"

namespace wend {

class JsonValue;

// The outline of a picture, and the parts that it is put together from.

void readOutline(const JsonValue& value, Project& project);
nlohmann::ordered_json outlineJson(const Project& project);

/// Reads domain.parts. Throws InputError for names that are not known, given twice, or that lead back to the
/// part itself.
void readParts(const JsonValue& value, Domain& domain);
nlohmann::ordered_json partsJson(const Domain& domain);

}  // namespace wend
