#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wend {

struct Project;

/// The range of a value. Open ends are not part of it.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool openMin = false;
    bool openMax = false;

    bool contains(double value) const;
    /// Returns mathematical notation, ]0, 1]; infinite ends are shown as ∞.
    std::string text() const;
};

/// For Unbounded: a number, or the word for infinity, which is the only choice. For Canvas: one of the
/// choices, or a rectangle of pixels; for Colour: one of them, or "#d9822b". An Output is a file that is
/// written, and may be given several times; a FilePair is one that is read and one that is written.
enum class OptionKind {
    Flag,
    Number,
    Integer,
    Unbounded,
    Phi,
    Choice,
    Canvas,
    Colour,
    Text,
    File,
    Output,
    FilePair
};
/// Returns whether an option may be given several times.
bool isRepeatable(OptionKind kind);

/// A value in a project. Every value is a number: a flag is 0 or 1, a choice its place in the list.
struct Accessor {
    double (*get)(const Project&) = nullptr;
    void (*set)(Project&, double) = nullptr;
};

/// The projects that have a setting.
struct Scope {
    bool (*holds)(const Project&) = nullptr;
    std::string_view words;  // "pictures": what it is for
};

/// The first stage that is recomputed when a setting changes, with all later ones.
enum class Makes { Nothing, Outline, Mesh, Material, Motion };

/// Says when a setting is written to a project's file. `ByHand` settings have code of their own that reads
/// and writes them, because they are more than a value there.
enum class InFile { IfChanged, Always, ByHand };

/// Accessors of a setting in a project.
struct Field {
    Accessor at = {};
    const Scope* scope = nullptr;  // none: any project
    Makes makes = Makes::Nothing;
    InFile inFile = InFile::IfChanged;
};

/// How the window shows a setting: English words, translated in the context "Options".
struct Row {
    const char* label = "";              // with a mnemonic; empty: it has no row
    const char* name = "";               // its name elsewhere; empty: the label
    const char* help = "";               // empty: the meaning
    const char* undo = "";               // name of the undo step
    const char* unit = "";               // behind the number
    const char* zero = "";               // in the place of the number 0
    std::array<const char*, 6> words{};  // of the choices
    double factor = 1;                   // of the shown number: 100 for percent
    int decimals = 0;                    // as many as needed if the number is smaller
    double step = 1;
    bool anySize = false;  // the number may have any magnitude
};

/// The single definition of a setting, from which follow: the project's reader and writer, invalidation, the
/// command line with its help and messages, the window's fields and the reference page.
struct Option {
    std::string_view key;   // in the project file; empty: on the command line only
    std::string_view flag;  // on the command line; empty: in the project only
    OptionKind kind = OptionKind::Number;
    std::string_view fallback;  // the default as text unless `field` has it; empty: none
    Range range;
    std::string_view unit;
    std::string_view choices;   // of Choice: "a|b|c"
    std::string_view commands;  // the subcommands that take the flag, separated by blanks
    std::string_view meaning;
    Field field = {};  // nowhere: of lists, of files, and of the command line only
    Row row = {};
};

/// Returns all settings in the order of the reference page.
std::span<const Option> options();
/// Returns the setting of that key or flag, which must exist.
const Option& option(std::string_view keyOrFlag);
/// Return the default as a number and as text (empty: none), and any value as text.
double defaultOf(const Option& option);
double defaultOf(std::string_view keyOrFlag);
std::string defaultText(const Option& option);
std::string textOf(const Option& option, double value);
/// Empty if the value is in range, else "0 is out of range: it must be in ]0, 1[".
std::string rangeProblem(const Option& option, double value);
/// Return the words of Choice, the index of one of them (their number if it is none), and whether it is one.
std::vector<std::string> choicesOf(const Option& option);
int placeOf(const Option& option, std::string_view choice);
bool isChoice(const Option& option, std::string_view value);
/// Describes values beside the choices; empty if there are none.
std::string formBesideChoices(const Option& option);

/// Returns φ of `equia`, `metr`, `akvf`, `conf`, or NaN for another word.
double phiOfName(std::string_view name, int dim);
/// Returns the name of exactly that φ, or an empty string.
std::string nameOfPhi(double phi, int dim);

/// Returns the shortest text that reads back as the same number, in the C locale.
std::string shortNumber(double value);

/// Returns the option's meaning, with the available formats in the place of {surfaces} and {volumes}.
std::string meaningOf(const Option& option);

/// Returns the table as a page of Markdown (docs/reference.md).
std::string referencePage();

}  // namespace wend
