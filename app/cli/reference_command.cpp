#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/command_table.h"
#include "app/cli/commands.h"
#include "app/project/file/text_file.h"
#include "app/project/options/options.h"

namespace wend {

namespace {

/// A page of the manual in section 1, in the language of man(7).
struct ManualPage {
    std::string name;  // "wend-run"
    std::string text;
};

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

/// Returns an entry of the manual page: the term in bold, its value in italics, and the meaning.
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

/// Returns wend(1), a page for each subcommand that the overview shows, and wend-mpi(1), all from the tables
/// of subcommands and options.
std::vector<ManualPage> manualPages() {
    std::vector<ManualPage> pages{overviewPage(), divisionPage()};
    for (const Command& one : commands())
        if (!one.hidden) pages.push_back(commandPage(one));
    return pages;
}

constexpr const char* kOrigin = "Written by `wend reference --completion`; do not edit.\n";

/// Returns the text within single quotes, as bash and zsh read them.
std::string inQuotes(std::string_view text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string flagOf(const OptionWords& words) {
    return std::string(words.option->flag);
}

bool takesFile(const OptionWords& words) {
    return words.option->kind == OptionKind::File || isRepeatable(words.option->kind);
}

std::string choicesOf(const OptionWords& words) {
    std::string text;
    for (const std::string& one : choicesOf(*words.option)) text += (text.empty() ? "" : " ") + one;
    return text;
}

std::string joined(const std::function<std::string(const Command&)>& each, const char* between) {
    std::string text;
    for (const Command& one : commands())
        if (!one.hidden) text += (text.empty() ? "" : between) + each(one);
    return text;
}

std::string flagsOf(const Command& command) {
    std::string text = "--help";
    for (const OptionWords& one : optionWords(command.name)) text += " " + flagOf(one);
    return text;
}

/// Returns the completion of an option's value: readline completes file names if nothing is offered; a number
/// has none.
std::string bashValue(const Command& command, const OptionWords& words) {
    if (words.value.empty() || takesFile(words)) return {};
    const std::string choices = choicesOf(words);
    return "        " + std::string(command.name) + ":" + flagOf(words) + ") " +
           (choices.empty() ? "compopt +o default"
                            : "COMPREPLY=($(compgen -W " + inQuotes(choices) + " -- \"$word\"))") +
           "; return ;;\n";
}

std::string bashCompletion() {
    std::string values, flags, files;
    for (const Command& command : commands()) {
        if (command.hidden) continue;
        const std::string name = command.name;
        flags += "        " + name + ") flags=" + inQuotes(flagsOf(command)) + " ;;\n";
        for (const OptionWords& one : optionWords(name)) {
            values += bashValue(command, one);
            if (takesFile(one)) files += (files.empty() ? "" : "|") + name + ":" + flagOf(one);
        }
    }
    return "# Completion of wend(1) in bash. " + std::string(kOrigin) +
           "_wend() {\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} flags=\n"
           "    COMPREPLY=()\n"
           "    if [ \"$word\" = = ]; then\n"
           "        word=\n"
           "    elif [ \"$before\" = = ]; then\n"
           "        before=${COMP_WORDS[COMP_CWORD-2]}\n"
           "    fi\n"
           "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
           "        COMPREPLY=($(compgen -W '" +
           joined([](const Command& one) { return std::string(one.name); }, " ") +
           " --help --version' -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    case ${COMP_WORDS[1]}:$before in\n"
           "        " +
           files + ") return ;;\n" + values +
           "    esac\n"
           "    case ${COMP_WORDS[1]} in\n" +
           flags +
           "    esac\n"
           "    [[ $word != -* ]] || COMPREPLY=($(compgen -W \"$flags\" -- \"$word\"))\n"
           "}\n"
           "complete -o default -F _wend wend\n";
}

/// Returns a description as it is within the brackets of _arguments.
std::string zshMeaning(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
        result += c;
    }
    return "[" + result + "]";
}

std::string zshOption(const OptionWords& words) {
    const std::string value = words.value.empty()             ? ""
                              : takesFile(words)              ? ":file:_files"
                              : words.option->choices.empty() ? ":value: "
                                                              : ":value:(" + choicesOf(words) + ")";
    const std::string second = words.option->kind == OptionKind::FilePair ? ":file:_files" : "";
    const std::string again = isRepeatable(words.option->kind) ? "*" : "";
    return inQuotes(again + flagOf(words) + (words.value.empty() || !second.empty() ? "" : "=") +
                    zshMeaning(words.meaning) + value + second);
}

std::string zshCommand(const Command& command) {
    std::string text =
        "                " + std::string(command.name) + ")\n                    _arguments \\\n";
    for (const OptionWords& one : optionWords(command.name))
        text += "                        " + zshOption(one) + " \\\n";
    return text +
           "                        '--help[print the options]' \\\n"
           "                        '*:file:_files' ;;\n";
}

std::string zshCompletion() {
    return "#compdef wend\n# Completion of wend(1) in zsh. " + std::string(kOrigin) +
           "_wend() {\n"
           "    local context state state_descr line\n"
           "    typeset -A opt_args\n"
           "    local -a commands=(\n" +
           joined(
               [](const Command& one) {
                   return "        " + inQuotes(std::string(one.name) + ":" + one.meaning) + "\n";
               },
               "") +
           "    )\n"
           "    _arguments -C '(- *)--help[print an overview]' '(- *)--version[print the version]' \\\n"
           "        '1: :->command' '*:: :->rest'\n"
           "    case $state in\n"
           "        command) _alternative 'commands:command:{_describe command commands}' "
           "'files:file:_files' ;;\n"
           "        rest)\n"
           "            case $words[1] in\n" +
           joined(zshCommand, "") +
           "            esac ;;\n"
           "    esac\n"
           "}\n"
           "_wend \"$@\"\n";
}

std::string fishOption(const Command& command, const OptionWords& words) {
    std::string text = "complete -c wend -n '__fish_seen_subcommand_from " + std::string(command.name) +
                       "' -l " + flagOf(words).substr(2);
    if (!words.shortFlag.empty()) text += " -s " + words.shortFlag.substr(1);
    if (takesFile(words)) text += " -r -F";
    if (!words.value.empty() && !takesFile(words)) text += " -x -a " + inQuotes(choicesOf(words));
    std::string meaning;
    for (const char c : words.meaning)
        meaning += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return text + " -d '" + meaning + "'\n";
}

std::string fishCommand(const Command& command) {
    std::string text = "complete -c wend -n __fish_use_subcommand -a " + std::string(command.name) + " -d " +
                       "\"" + command.meaning + "\"\n";
    for (const OptionWords& one : optionWords(command.name)) text += fishOption(command, one);
    return text;
}

std::string fishCompletion() {
    return "# Completion of wend(1) in fish. " + std::string(kOrigin) + joined(fishCommand, "") +
           "complete -c wend -l help -s h -d 'print the options'\n"
           "complete -c wend -n __fish_use_subcommand -l version -d 'print the version'\n";
}

/// Returns the script that completes the program's command line in "bash", "zsh" or "fish", from the tables
/// of subcommands and options: commands, options, choices and file names.
std::string completionFor(const std::string& shell) {
    return shell == "bash" ? bashCompletion() : shell == "zsh" ? zshCompletion() : fishCompletion();
}

void writeManualPages(const std::filesystem::path& folder) {
    for (const ManualPage& page : manualPages())
        writeTextFile((folder / (page.name + ".1")).string(), page.text);
}

}  // namespace

ExitCode runReference(const Arguments& arguments) {
    if (!arguments.files().empty()) throw UsageError("`wend reference` takes no file");
    if (arguments.has("--man")) writeManualPages(arguments.text("--man"));
    if (arguments.has("--completion")) return print(completionFor(arguments.text("--completion")));
    return arguments.has("--man") ? ExitCode::Done : print(referencePage());
}

}  // namespace wend
