#include "app/cli/cli.h"

#include <array>
#include <filesystem>
#include <system_error>

#include "app/bench/bench.h"
#include "app/cli/commands.h"
#include "app/cli/guarded.h"
#include "warp/film_format.h"

namespace wend {
namespace {

struct Command {
    const char* name;
    const char* usage;
    const char* meaning;
    ExitCode (*run)(const Arguments&);
    bool hidden = false;
};

constexpr std::array kCommands{
    Command{"run", "PROJECT [outputs] [options]", "deform as the project says and write what is asked for",
            runRun},
    Command{"mesh", "INPUT -o OUT [options]",
            "mesh a picture, an outline, a project's domain or a closed surface", runMesh},
    Command{"info", "FILE [--json] [--problems OUT]", "tell what Wend sees in a picture, mesh or project",
            runInfo},
    Command{"convert", "IN OUT [options]", "write a mesh or picture in another format, by the extensions",
            runConvert},
    Command{"devices", "", "list the devices that can compute, and which is used", runDevices},
    Command{"bench", "[CASE …]", "measure the speed on this machine", runBench},
    Command{"reference", "", "print the reference of all settings", runReference, true},
};

const Command* findCommand(const std::string& name) {
    for (const Command& one : kCommands)
        if (name == one.name) return &one;
    return nullptr;
}

std::string overview() {
    std::string text =
        "Wend warps pictures and bends solid shapes by letting them flow.\n\n"
        "Usage:\n  wend [FILE]                 open the window, with a picture, mesh or project\n"
        "  wend COMMAND …              work without a window:\n\n";
    for (const Command& one : kCommands) {
        std::string name = "    " + std::string(one.name);
        name.resize(16, ' ');
        if (!one.hidden) text += name + one.meaning + "\n";
    }
    return text +
           "\nOptions:\n  --help                      this; `wend COMMAND --help` for one of them\n"
           "  --version                   the version\n\n"
           "Exit codes: 0 done, 1 internal error, 2 wrong usage, 3 an input cannot be read or makes no "
           "sense\n"
           "(or an output cannot be written), 4 the deformation could not be completed, 5 the machine has "
           "not the\nmemory or the disk that is needed.\n";
}

std::string joinedCases() {
    std::string text;
    for (const std::string& name : benchCases()) text += " " + name;
    return text;
}

std::string helpFor(const Command& command) {
    std::string text =
        "Usage: wend " + std::string(command.name) + " " + command.usage + "\n\n" + command.meaning + "\n";
    const std::string options = optionHelp(command.name);
    if (!options.empty()) text += "\nOptions:\n" + options;
    if (std::string(command.name) == "bench")
        text += "\nCases:" + joinedCases() +
                "; without any, all but paper, which shows what the figures of the "
                "paper\nshow, tells whether its findings hold, and has its table of times.\n";
    if (std::string(command.name) == "run")
        text +=
            "\nA file named - is standard output (one of them). Either all outputs are written, or none; if "
            "the\n"
            "deformation stops early, only the report is, with the last good time (see --partial).\n"
            "`mpirun -q -n N wend-mpi run …` divides a large solid among N processes.\n";
    return text;
}

/// With the programs that films need.
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
