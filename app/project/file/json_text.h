#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/project/extras.h"

namespace wend {

/// Parses JSON strictly. Throws InputError(path, "line 3, column 7: …") for a syntax error, a number too
/// large, a key given twice in one object or nesting deeper than any project needs.
nlohmann::ordered_json parseJson(const std::string& text, const std::string& path);

/// Returns readable JSON for comparison: short values on one line, long rows of numbers filled, numbers in
/// the shortest form that reads back equal. Ends with a newline. Throws InputError for text that is not
/// UTF-8.
std::string prettyJson(const nlohmann::ordered_json& json);

/// Adds unknown keys of a file again, except those of objects that no longer exist.
nlohmann::ordered_json withExtras(nlohmann::ordered_json json, const Extras& extras);

}  // namespace wend
