#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace wend {

/// What a value may be. An open end is not part of the range.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool openMin = false;
    bool openMax = false;

    bool contains(double value) const;
    /// As in mathematics, ]0, 1]; infinite ends are shown as ∞.
    std::string text() const;
};

enum class OptionKind { Flag, Number, Integer, Phi, Choice, Text, File };

/// One setting, told once: the project's reader, the command line's help and messages, the window's spin
/// boxes and the reference page all take it from here.
struct Option {
    std::string_view key;   // in the project file; empty: on the command line only
    std::string_view flag;  // on the command line; empty: in the project only
    OptionKind kind = OptionKind::Number;
    std::string_view fallback;  // the default as one would write it; empty: none
    Range range;
    std::string_view unit;
    std::string_view choices;   // of Choice: "a|b|c"
    std::string_view commands;  // the subcommands that take the flag, separated by blanks
    std::string_view meaning;
};

/// All settings in the order of the reference page.
std::span<const Option> options();
/// The setting of that key or flag. It must exist.
const Option& option(std::string_view keyOrFlag);
/// The default of a number or integer.
double defaultOf(std::string_view keyOrFlag);
/// Empty if the value is in range, else "0 is out of range: it must be in ]0, 1[".
std::string rangeProblem(const Option& option, double value);
bool isChoice(const Option& option, std::string_view value);

/// ]0, φ_CONF(dim)]
Range phiRange(int dim);
/// Empty, or what is wrong with φ; the text states the range.
std::string phiProblem(double phi, int dim);
/// φ of `equia`, `metr`, `akvf`, `conf`, or NaN for another word.
double phiOfName(std::string_view name, int dim);
/// The name of exactly that φ, or empty.
std::string nameOfPhi(double phi, int dim);

/// The shortest text that reads back as the same number, in the C locale.
std::string numberText(double value);

/// The table as a page of Markdown (docs/reference.md).
std::string referencePage();

}  // namespace wend
