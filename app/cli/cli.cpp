#include "app/cli/cli.h"

#include <filesystem>
#include <system_error>

#include "app/cli/command_table.h"
#include "app/cli/guarded.h"
#include "warp/film_format.h"

namespace wend {
namespace {

std::string overview() {
    std::string text =
        "Wend warps pictures and bends solid shapes by letting them flow.\n\n"
        "Usage:\n  wend [FILE]                 open the window, with a picture, mesh or project\n"
        "  wend COMMAND …              work without a window:\n\n";
    for (const Command& one : commands()) {
        std::string name = "    " + std::string(one.name);
        name.resize(16, ' ');
        if (!one.hidden) text += name + one.meaning + "\n";
    }
    return text +
           "\nOptions:\n  --help                      this; `wend COMMAND --help` for one of them\n"
           "  --version                   the version\n\n" +
           exitCodeText();
}

std::string helpFor(const Command& command) {
    std::string text =
        "Usage: wend " + std::string(command.name) + " " + command.usage + "\n\n" + command.meaning + "\n";
    const std::string options = optionHelp(command.name);
    if (!options.empty()) text += "\nOptions:\n" + options;
    if (const std::string remarks = remarksOn(command); !remarks.empty()) text += "\n" + remarks;
    return text;
}

/// Returns the version, with the programs that films need.
std::string versionText() {
    const std::string ffmpeg = ffmpegVersion();
    return "wend " WEND_VERSION "\nffmpeg " + (ffmpeg.empty() ? "is not installed" : ffmpeg) + "\n";
}

ExitCode dispatch(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "--help" || words[0] == "-h") return print(overview());
    if (words[0] == "--version") return print(versionText());
    const Command* command = findCommand(words[0]);
    if (!command) throw UsageError("there is no command or file " + words[0] + " (see wend --help)");
    const std::vector<std::string> rest(words.begin() + 1, words.end());
    for (const std::string& word : rest)
        if (word == "--help" || word == "-h") return print(helpFor(*command));
    return command->run(Arguments(command->name, rest));
}

}  // namespace

bool isCommand(const std::string& word) {
    if (word.starts_with("--") || word == "-h" || findCommand(word)) return true;
    if (word.starts_with("-")) return false;  // -platform, -style …: the window's
    std::error_code error;
    return word.find_first_of("./") == std::string::npos && !std::filesystem::exists(word, error);
}

int runCommand(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    return runToTheEnd([&] { return dispatch(words); });
}

}  // namespace wend
