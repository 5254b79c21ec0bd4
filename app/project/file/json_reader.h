#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/project/extras.h"
#include "app/project/options/options.h"
#include "core/base/types.h"

namespace wend {

/// A value of a project with its path for messages. Every failure is an InputError such as
/// "handles[2].motion[0].points: reason".
class JsonValue {
  public:
    using Json = nlohmann::ordered_json;
    /// Unknown keys are added to `warnings` and kept in `extras`, relative to its origin.
    JsonValue(const Json& json, std::string path, Extras& extras, std::vector<std::string>& warnings)
        : m_json(&json), m_path(std::move(path)), m_extras(&extras), m_warnings(&warnings) {}

    [[noreturn]] void fail(const std::string& what) const;
    void warn(const std::string& what) const;
    const std::string& path() const { return m_path; }
    const Json& json() const { return *m_json; }

    JsonValue member(const std::string& key) const;
    /// Returns the elements of a list.
    std::vector<JsonValue> elements() const;
    /// Returns the same value, which keeps the unknown keys in and below it in `extras`.
    JsonValue ownedBy(Extras& extras) const;
    /// Keeps a key that is not known and warns about it. `near`: the known key that it resembles, if any.
    void keepUnknown(const std::string& key, const std::string& near = {}) const;

    /// Keeps `name`, the JSON that names this value, in the extras until the named place is found.
    void keepName(const Json& name) const;

    std::string text() const;
    bool boolean() const;
    double number() const;
    /// Returns a number in the option's range.
    double number(std::string_view optionKey) const;
    int integer() const;
    int integer(std::string_view optionKey) const;
    /// Returns one of the option's words.
    std::string choice(std::string_view optionKey) const;
    /// Returns its index among them as an enumeration.
    template <class Enum>
    Enum choice(std::string_view optionKey) const {
        return static_cast<Enum>(placeOf(option(optionKey), choice(optionKey)));
    }
    std::vector<double> numbers() const;

    /// Returns the number of coordinates of points in and below this value.
    int dimension() const { return m_dimension; }
    JsonValue ofDimension(int dimension) const;
    /// Returns a point; in the plane its z is 0.
    Vec3 point() const;
    std::vector<Vec3> points() const;
    /// Returns a point of the plane, which has two coordinates.
    Vec2 flatPoint() const { return inPlane(ofDimension(2).point()); }
    std::vector<Vec2> flatPoints() const;

  private:
    const Json* m_json;
    std::string m_path;
    std::string m_pointer;  // relative to the owner of m_extras
    int m_dimension = 2;
    Extras* m_extras;
    std::vector<std::string>* m_warnings;
};

/// Reads an object; keys that were not requested by the end are unknown. Messages about those name the known
/// key that they resemble: "`center` is not known; `centre`?".
class JsonObject {
  public:
    explicit JsonObject(JsonValue value);

    JsonValue require(const std::string& key);
    std::optional<JsonValue> find(const std::string& key);
    bool has(const std::string& key) const;
    /// Returns the one of these keys that is there; fails if none or several are.
    std::string oneOf(const std::vector<std::string>& keys) const;
    /// Fails because none of these keys is there: with the one that is misspelt, if there is such a one, else
    /// as `what` says.
    [[noreturn]] void failWithout(const std::vector<std::string>& keys, const std::string& what) const;
    /// Keeps all keys that were not asked for, and warns about them.
    void finish() const;
    const JsonValue& value() const { return m_value; }
    /// Sets the number of coordinates of points in the members that are read from now on.
    void setDimension(int dimension) { m_value = m_value.ofDimension(dimension); }

  private:
    std::string suggestionFor(const std::string& unknown) const;
    std::string unknownKeys() const;

    JsonValue m_value;
    std::set<std::string> m_known;           // that were read
    mutable std::set<std::string> m_wanted;  // that were looked for
};

}  // namespace wend
