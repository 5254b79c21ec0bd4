#include "app/project/file/json_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include "app/project/options/options.h"
#include "core/base/error.h"

namespace wend {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepest = 64;
constexpr std::size_t kLineWidth = 110;

/// Watches the parser: the library keeps silent about keys given twice and recurses as deep as the text says.
class ParseGuard {
  public:
    bool operator()(int depth, Json::parse_event_t event, const Json& value) {
        if (depth > kDeepest)
            throw InputError("is nested deeper than " + std::to_string(kDeepest) + " levels");
        if (event == Json::parse_event_t::object_start) m_keys.emplace_back();
        if (event == Json::parse_event_t::object_end) m_keys.pop_back();
        if (event == Json::parse_event_t::key && !m_keys.back().insert(value.get<std::string>()).second)
            throw InputError("the key `" + value.get<std::string>() + "` is given twice in one object");
        return true;
    }

  private:
    std::vector<std::set<std::string>> m_keys;
};

/// Returns "line 3, column 7" for the number of bytes that the parser had read.
std::string placeOf(const std::string& text, std::size_t bytes) {
    const std::string_view before = std::string_view(text).substr(0, bytes == 0 ? 0 : bytes - 1);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto start = before.rfind('\n');
    const std::size_t column = start == std::string_view::npos ? before.size() + 1 : before.size() - start;
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Returns the library's message without its prefix "[json.exception.parse_error.101] parse error at line 3,
/// column 7: ".
std::string bareReason(std::string what) {
    if (what.starts_with('[')) what.erase(0, what.find("] ") + 2);
    if (what.starts_with("parse error")) what.erase(0, what.find(": ") + 2);
    return what;
}

/// Returns where the number is that is too large: the library names it, but not its place.
std::string placeOfOverflow(const std::string& text, const std::string& reason) {
    const auto begin = reason.find('\''), end = reason.rfind('\'');
    if (begin == end) return {};
    const std::string number = reason.substr(begin + 1, end - begin - 1);
    const auto continues = [&](std::size_t at) {
        return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 ||
                                    std::string_view(".+-\"").find(text[at]) != std::string_view::npos);
    };
    auto at = text.find(number);
    while (at != std::string::npos && (continues(at - 1) || continues(at + number.size())))
        at = text.find(number, at + 1);
    return at == std::string::npos ? "" : placeOf(text, at + 1) + ": ";
}

class Printer {
  public:
    std::string print(const Json& json) {
        value(json, 0);
        return m_text + "\n";
    }

  private:
    static std::string number(double value) {
        if (!std::isfinite(value)) return "null";  // as the library writes it
        if (value == 0 && std::signbit(value)) return "-0.0";
        return shortNumber(value);
    }

    static std::string compact(const Json& json) {
        if (json.is_number_float()) return number(json.get<double>());
        if (!json.is_structured()) return json.dump();
        std::string text;
        for (auto it = json.begin(); it != json.end(); ++it) {
            if (!text.empty()) text += ", ";
            if (json.is_object()) text += Json(it.key()).dump() + ": ";
            text += compact(*it);
        }
        return json.is_object() ? "{" + text + "}" : "[" + text + "]";
    }

    void value(const Json& json, int depth) {
        const std::string line = compact(json);
        const bool fits = line.size() + 2 * depth <= kLineWidth;
        if (!json.is_structured() || json.empty() || (depth > 0 && fits))
            m_text += line;
        else if (json.is_array() && json.front().is_number())
            filled(json, depth);
        else
            broken(json, depth);
    }

    void newLine(int depth) { m_text += "\n" + std::string(2 * depth, ' '); }

    /// Writes one entry per line.
    void broken(const Json& json, int depth) {
        m_text += json.is_object() ? "{" : "[";
        for (auto it = json.begin(); it != json.end(); ++it) {
            if (it != json.begin()) m_text += ",";
            newLine(depth + 1);
            if (json.is_object()) m_text += Json(it.key()).dump() + ": ";
            value(*it, depth + 1);
        }
        newLine(depth);
        m_text += json.is_object() ? "}" : "]";
    }

    /// Writes as many numbers per line as fit.
    void filled(const Json& json, int depth) {
        m_text += "[";
        std::size_t column = kLineWidth;
        for (std::size_t i = 0; i < json.size(); ++i) {
            const std::string entry = compact(json[i]) + (i + 1 < json.size() ? "," : "");
            if (column + entry.size() + 1 > kLineWidth) {
                newLine(depth + 1);
                column = 2 * (depth + 1);
            } else {
                m_text += " ";
                ++column;
            }
            m_text += entry;
            column += entry.size();
        }
        newLine(depth);
        m_text += "]";
    }

    std::string m_text;
};

}  // namespace

Json parseJson(const std::string& text, const std::string& path) try {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw InputError("is empty");
    ParseGuard guard;
    return Json::parse(
        text, [&](int depth, Json::parse_event_t event, Json& value) { return guard(depth, event, value); });
} catch (const InputError& error) {
    throw error.named(path);
} catch (const Json::parse_error& error) {
    throw InputError(path,
                     "is not valid JSON: " + placeOf(text, error.byte) + ": " + bareReason(error.what()));
} catch (const Json::exception& error) {
    const std::string reason = bareReason(error.what());
    throw InputError(path, "is not valid JSON: " + placeOfOverflow(text, reason) + reason);
}

std::string prettyJson(const Json& json) try {
    return Printer().print(json);
} catch (const Json::exception& error) {
    throw InputError("has text that is not UTF-8: " + bareReason(error.what()));
}

Json withExtras(Json json, const Extras& extras) {
    for (const auto& [pointer, text] : extras) {
        const Json::json_pointer place(pointer);
        const Json::json_pointer parent = place.parent_pointer();
        if (json.contains(parent) && json[parent].is_object()) json[place] = Json::parse(text);
    }
    return json;
}

}  // namespace wend
