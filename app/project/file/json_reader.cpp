#include "app/project/file/json_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/project/file/nearest_word.h"
#include "core/base/error.h"

namespace wend {
namespace {

std::string escaped(const std::string& key) {
    std::string text;
    for (char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

/// Describes the value that was found: "a list", "the text "abc"" …
std::string kindOf(const nlohmann::ordered_json& json) {
    if (json.is_object()) return "an object";
    if (json.is_array()) return "a list";
    if (json.is_string()) return "the text " + json.dump().substr(0, 60);
    return json.dump();
}

std::string isUnknown(const std::string& key, const std::string& near) {
    return "`" + key + "` is not known; `" + near + "`?";
}

}  // namespace

void JsonValue::fail(const std::string& what) const {
    throw InputError(m_path.empty() ? what : m_path + ": " + what);
}

void JsonValue::warn(const std::string& what) const {
    m_warnings->push_back(m_path + ": " + what);
}

JsonValue JsonValue::member(const std::string& key) const {
    JsonValue child = *this;
    child.m_json = &m_json->at(key);
    child.m_path += (m_path.empty() ? "" : ".") + key;
    child.m_pointer += "/" + escaped(key);
    return child;
}

std::vector<JsonValue> JsonValue::elements() const {
    if (!m_json->is_array()) fail("must be a list, not " + kindOf(*m_json));
    std::vector<JsonValue> all;
    all.reserve(m_json->size());
    for (std::size_t i = 0; i < m_json->size(); ++i) {
        JsonValue child = *this;
        child.m_json = &(*m_json)[i];
        child.m_path += "[" + std::to_string(i) + "]";
        child.m_pointer += "/" + std::to_string(i);
        all.push_back(std::move(child));
    }
    return all;
}

JsonValue JsonValue::ownedBy(Extras& extras) const {
    JsonValue owned = *this;
    owned.m_extras = &extras;
    owned.m_pointer.clear();
    return owned;
}

void JsonValue::keepUnknown(const std::string& key, const std::string& near) const {
    m_extras->emplace_back(m_pointer + "/" + escaped(key), m_json->at(key).dump());
    if (!near.empty())
        return m_warnings->push_back((m_path.empty() ? "" : m_path + ": ") + isUnknown(key, near) +
                                     " It is ignored and kept");
    m_warnings->push_back(member(key).path() + ": is not known to this version; it is ignored and kept");
}

void JsonValue::keepName(const Json& name) const {
    m_extras->emplace_back(m_pointer, name.dump());
}

std::string JsonValue::text() const {
    if (!m_json->is_string()) fail("must be a text, not " + kindOf(*m_json));
    return m_json->get<std::string>();
}

bool JsonValue::boolean() const {
    if (!m_json->is_boolean()) fail("must be true or false, not " + kindOf(*m_json));
    return m_json->get<bool>();
}

double JsonValue::number() const {
    if (!m_json->is_number()) fail("must be a number, not " + kindOf(*m_json));
    const double value = m_json->get<double>();
    if (!std::isfinite(value)) fail("is not a finite number");
    return value;
}

double JsonValue::number(std::string_view optionKey) const {
    const double value = number();
    if (const std::string problem = rangeProblem(option(optionKey), value); !problem.empty()) fail(problem);
    return value;
}

int JsonValue::integer() const {
    const double value = number();
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
        fail("must be a whole number, not " + kindOf(*m_json));
    return static_cast<int>(value);
}

int JsonValue::integer(std::string_view optionKey) const {
    number(optionKey);
    return integer();
}

std::string JsonValue::choice(std::string_view optionKey) const {
    const std::string word = text();
    if (!isChoice(option(optionKey), word)) {
        std::string known;
        for (char c : option(optionKey).choices) known += c == '|' ? std::string(", ") : std::string(1, c);
        fail("unknown value \"" + word + "\"; known are " + known);
    }
    return word;
}

std::vector<double> JsonValue::numbers() const {
    std::vector<double> all;
    for (const JsonValue& element : elements()) all.push_back(element.number());
    return all;
}

Vec3 JsonValue::point() const {
    const std::vector<double> values = numbers();
    if (values.size() != static_cast<std::size_t>(m_dimension))
        fail("has " + std::to_string(values.size()) + " numbers where this " + std::to_string(m_dimension) +
             "D project needs " + std::to_string(m_dimension));
    return {values[0], values[1], m_dimension == 3 ? values[2] : 0};
}

std::vector<Vec3> JsonValue::points() const {
    std::vector<Vec3> all;
    for (const JsonValue& element : elements()) all.push_back(element.point());
    return all;
}

std::vector<Vec2> JsonValue::flatPoints() const {
    std::vector<Vec2> all;
    for (const JsonValue& element : elements()) all.push_back(element.flatPoint());
    return all;
}

JsonValue JsonValue::ofDimension(int dimension) const {
    JsonValue value = *this;
    value.m_dimension = dimension;
    return value;
}

JsonObject::JsonObject(JsonValue value) : m_value(std::move(value)) {
    if (!m_value.json().is_object()) m_value.fail("must be an object, not " + kindOf(m_value.json()));
}

JsonValue JsonObject::require(const std::string& key) {
    if (!has(key)) failWithout({key}, "the key `" + key + "` is missing");
    m_known.insert(key);
    return m_value.member(key);
}

std::optional<JsonValue> JsonObject::find(const std::string& key) {
    if (!has(key)) return std::nullopt;
    m_known.insert(key);
    return m_value.member(key);
}

std::string JsonObject::oneOf(const std::vector<std::string>& keys) const {
    std::string list, found;
    for (const std::string& key : keys) {
        list += (list.empty() ? "" : ", ") + key;
        if (!has(key)) continue;
        if (!found.empty()) m_value.fail("has both `" + found + "` and `" + key + "`");
        found = key;
    }
    if (found.empty()) failWithout(keys, "has none of the known kinds: " + list + unknownKeys());
    return found;
}

bool JsonObject::has(const std::string& key) const {
    m_wanted.insert(key);
    return m_value.json().contains(key);
}

std::string JsonObject::unknownKeys() const {
    for (const auto& entry : m_value.json().items())
        if (!m_known.contains(entry.key())) return "; `" + entry.key() + "` is not known";
    return {};
}

std::string JsonObject::suggestionFor(const std::string& unknown) const {
    std::vector<std::string> absent;
    std::ranges::copy_if(m_wanted, std::back_inserter(absent),
                         [&](const std::string& key) { return !m_value.json().contains(key); });
    return meantKey(unknown, absent);
}

void JsonObject::failWithout(const std::vector<std::string>& keys, const std::string& what) const {
    for (const auto& entry : m_value.json().items()) {
        const bool isKnown = m_known.contains(entry.key());
        if (const std::string near = isKnown ? "" : meantKey(entry.key(), keys); !near.empty())
            m_value.fail(isUnknown(entry.key(), near));
    }
    m_value.fail(what);
}

void JsonObject::finish() const {
    for (const auto& entry : m_value.json().items())
        if (!m_known.contains(entry.key())) m_value.keepUnknown(entry.key(), suggestionFor(entry.key()));
}

}  // namespace wend
