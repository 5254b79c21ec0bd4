#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace wend {

/// Parses JSON strictly. Throws InputError(path, "line 3, column 7: …") for a syntax error, a number too
/// large, a key given twice in one object or nesting deeper than any project needs.
nlohmann::ordered_json parseJson(const std::string& text, const std::string& path);

/// For people to read and to compare: what is short stands on one line, long rows of numbers are filled,
/// numbers are the shortest that read back the same. Ends with a newline. Throws InputError for text that is
/// not UTF-8.
std::string prettyJson(const nlohmann::ordered_json& json);

}  // namespace wend
