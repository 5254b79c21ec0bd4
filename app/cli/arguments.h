#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "app/project/options/option_values.h"
#include "app/project/project_fwd.h"

namespace wend {

struct Option;

/// The command line itself is wrong (exit code 2).
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The arguments of a subcommand, checked against the table of options.
class Arguments {
  public:
    /// `words` follow the subcommand's name. Throws UsageError for an unknown option, one that the subcommand
    /// does not take, one given twice that is not an output, one without its value, and a value of the wrong
    /// kind or out of range.
    Arguments(const std::string& command, const std::vector<std::string>& words);

    /// Returns what followed the subcommand's name, unchanged.
    const std::vector<std::string>& words() const { return m_words; }
    const std::vector<std::string>& files() const { return m_files; }
    const OptionValues& values() const { return m_values; }
    bool has(const std::string& flag) const { return m_values.has(flag); }
    std::string text(const std::string& flag) const { return m_values.text(flag); }
    /// Returns the values of an option that may be repeated, in their order; of pairs both.
    std::vector<std::string> texts(const std::string& flag) const { return m_values.texts(flag); }
    double number(const std::string& flag) const { return m_values.number(flag); }
    int integer(const std::string& flag) const { return m_values.integer(flag); }
    std::optional<double> given(const std::string& flag) const { return m_values.given(flag); }
    /// Returns φ of a name or number, in the range of that dimension.
    double phi(const std::string& flag, int dim) const;
    /// Returns the value of an option of any kind but a file as a number: see Accessor.
    double value(const Option& option, int dim) const;

  private:
    void take(const std::string& flag, const std::optional<std::string>& attached,
              const std::vector<std::string>& words, std::size_t& at);

    std::string m_command;
    std::vector<std::string> m_words, m_files;
    OptionValues m_values;
};

/// Applies the settings of the command line, which take precedence over the project's.
void takeSettings(Project& project, const Arguments& arguments);
/// Throws UsageError for an option that would change nothing in this project.
void requireFitting(const Project& project, const Arguments& arguments);

/// An option of a subcommand, in words.
struct OptionWords {
    const Option* option = nullptr;
    std::string shortFlag;  // "-o"; empty: it has none
    std::string value;      // "X", "IN OUT", "auto|opencl|cpu"; empty: it takes none
    std::string meaning;    // with default, range and unit
};
/// Returns the options that the subcommand takes, in the order of the table.
std::vector<OptionWords> optionWords(const std::string& command);
/// Returns the help for a command's options, `--tolerance X  …` for each of them.
std::string optionHelp(const std::string& command);

}  // namespace wend
