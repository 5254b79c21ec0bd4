#include "app/cli/completion.h"

#include <functional>
#include <string_view>

#include "app/cli/command_table.h"
#include "app/project/options/options.h"

namespace wend {
namespace {

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

}  // namespace

std::string completionFor(const std::string& shell) {
    return shell == "bash" ? bashCompletion() : shell == "zsh" ? zshCompletion() : fishCompletion();
}

}  // namespace wend
