#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wend {

/// The values of options by their flags, as they are written on the command line or set in the window's
/// dialogs. Options that are not set have the defaults of the table.
class OptionValues {
  public:
    void set(const std::string& flag, std::string value) { m_values[flag] = {std::move(value)}; }
    /// Adds a value to those of an option that may be repeated.
    void add(const std::string& flag, std::string value) { m_values[flag].push_back(std::move(value)); }
    bool has(const std::string& flag) const { return m_values.contains(flag); }
    /// Returns the text as written, or the table's default.
    std::string text(const std::string& flag) const;
    /// Returns all values that were given, without defaults.
    std::vector<std::string> texts(const std::string& flag) const;
    double number(const std::string& flag) const;
    int integer(const std::string& flag) const;
    /// Returns the position of a choice in its list as an enumerator.
    template <class Enum>
    Enum choice(const std::string& flag) const {
        return static_cast<Enum>(place(flag));
    }
    /// Returns the value that was set, without defaults.
    std::optional<double> given(const std::string& flag) const;

    bool operator==(const OptionValues&) const = default;

  private:
    int place(const std::string& flag) const;

    std::map<std::string, std::vector<std::string>> m_values;
};

/// Parses a number of the command line: the whole text, in the C locale.
std::optional<double> finiteNumber(const std::string& text);

}  // namespace wend
