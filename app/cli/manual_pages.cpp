#include "app/cli/manual_pages.h"

#include <string_view>

#include "app/cli/command_table.h"
#include "app/project/options/options.h"

namespace wend {
namespace {

constexpr const char* kProject = "https://www.gnu.org/licenses/agpl-3.0.html";

/// Escapes text for roff: a hyphen can be copied as it is typed, no backslash escapes, and no line begins
/// with a dot or an apostrophe that makes it a control line.
std::string escaped(std::string_view text) {
    std::string result;
    bool lineBegins = true;
    for (const char c : text) {
        if (lineBegins && (c == '.' || c == '\'')) result += "\\&";
        if (c == '-')
            result += "\\-";
        else if (c == '\\')
            result += "\\e";
        else
            result += c;
        lineBegins = c == '\n';
    }
    return result;
}

/// Returns a text as an argument of a macro.
std::string macroArgument(std::string_view text) {
    std::string result = "\"";
    for (const char c : escaped(text)) result += c == '"' ? std::string("\\(dq") : std::string(1, c);
    return result + "\"";
}

std::string heading(const std::string& page, const std::string& meaning) {
    std::string upper = page;
    for (char& c : upper) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    return ".TH " + macroArgument(upper) + " 1 \"\" " + macroArgument("Wend " WEND_VERSION) +
           " \"User Commands\"\n.SH NAME\n" + escaped(page) + " \\- " + escaped(meaning) + "\n";
}

std::string section(const std::string& title, const std::string& text) {
    return ".SH " + macroArgument(title) + "\n" + text + (text.ends_with('\n') ? "" : "\n");
}

/// A term in bold, what follows it in italics, and its meaning.
std::string entry(const std::string& term, const std::string& value, const std::string& meaning) {
    return ".TP\n\\fB" + escaped(term) + "\\fR" + (value.empty() ? "" : " \\fI" + escaped(value) + "\\fR") +
           "\n" + escaped(meaning) + "\n";
}

std::string optionEntry(const OptionWords& words) {
    const std::string brief = words.shortFlag.empty() ? "" : words.shortFlag + ", ";
    return entry(brief + std::string(words.option->flag), words.value, words.meaning);
}

std::string synopsis(const std::string& program, const std::string& usage) {
    return section("SYNOPSIS", ".B " + macroArgument(program) + "\n" + escaped(usage) + "\n");
}

std::string ending(const std::string& others) {
    return section("EXIT STATUS", escaped(exitCodeText())) + section("SEE ALSO", others) +
           section("LICENSE", escaped(std::string("AGPL-3.0-or-later: ") + kProject));
}

std::string reference(const std::string& page, const char* after = "") {
    return ".BR " + macroArgument(page) + " (1)" + after + "\n";
}

std::string optionSection(const std::string& command) {
    std::string text;
    for (const OptionWords& one : optionWords(command)) text += optionEntry(one);
    return section("OPTIONS", text + entry("-h, --help", "", "print the options"));
}

ManualPage overviewPage() {
    std::string list, others;
    for (const Command& one : commands()) {
        if (one.hidden) continue;
        const std::string page = "wend-" + std::string(one.name);
        list += entry("wend " + std::string(one.name), one.usage, one.meaning);
        others += reference(page, ",");
    }
    std::string text = heading("wend", "warp pictures and bend solid shapes by letting them flow");
    text += section("SYNOPSIS", ".B wend\n[FILE]\n.br\n.B wend\nCOMMAND …\n");
    text += section(
        "DESCRIPTION",
        "Without a command, or with a picture, a mesh or a project, the window opens. With a command no "
        "display is needed; each has a page of its own.");
    text += section("COMMANDS", list);
    text += section("OPTIONS", entry("-h, --help", "", "print an overview; after a command, its options") +
                                   entry("--version", "", "print the version"));
    text += section("ENVIRONMENT",
                    entry("WEND_SIMD", "sse2|ssse3|sse4|avx2|avx512", "the instruction set to compute with") +
                        entry("WEND_DEVICE", "TEXT", "the OpenCL device whose name holds this"));
    text += section("FILES",
                    escaped("A project is a text file *.wend in JSON; the manual in the window describes it, "
                            "with all that is in these pages and more."));
    return {"wend", text + ending(others + reference("wend-mpi"))};
}

ManualPage commandPage(const Command& command) {
    const std::string name = "wend-" + std::string(command.name);
    std::string text =
        heading(name, command.meaning) + synopsis("wend " + std::string(command.name), command.usage);
    text += optionSection(command.name);
    if (const std::string remarks = remarksOn(command); !remarks.empty())
        text += section("NOTES", escaped(remarks));
    return {name, text + ending(reference("wend"))};
}

ManualPage divisionPage() {
    std::string text = heading("wend-mpi", "divide wend run among processes and machines");
    text += section("SYNOPSIS",
                    ".B " + macroArgument("mpirun -q -n N wend-mpi run") + "\nPROJECT [outputs] [options]\n");
    text += section(
        "DESCRIPTION",
        escaped("Deforms as the project says, like ") + "\n" + reference("wend-run", ",") +
            escaped("with the mesh divided among the processes that mpirun or srun starts together: for "
                    "solids that one machine does not hold. It takes the options of\n") +
            reference("wend-run", ".") +
            escaped("A process that is lost is named, and all end with exit code 137."));
    return {"wend-mpi", text + ending(reference("wend", ",") + reference("wend-run"))};
}

}  // namespace

std::vector<ManualPage> manualPages() {
    std::vector<ManualPage> pages{overviewPage(), divisionPage()};
    for (const Command& one : commands())
        if (!one.hidden) pages.push_back(commandPage(one));
    return pages;
}

}  // namespace wend
