#include "app/cli/cli.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <system_error>

#include "app/bench/bench.h"
#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/mesh/input_file.h"
#include "core/mesh/printable.h"
#include "core/mesh/safe_file.h"

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
            "deformation stops early, only the report is, with the last good time (see --partial).\n";
    return text;
}

ExitCode dispatch(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "--help" || words[0] == "-h") return print(overview());
    if (words[0] == "--version") return print("wend " WEND_VERSION "\n");
    const Command* command = findCommand(words[0]);
    if (!command) throw UsageError("there is no command or file " + words[0] + " (see wend --help)");
    const std::vector<std::string> rest(words.begin() + 1, words.end());
    for (const std::string& word : rest)
        if (word == "--help" || word == "-h") return print(helpFor(*command));
    return command->run(Arguments(command->name, rest));
}

[[noreturn]] void noMemory() {
    Terminal::lastWord("there is not enough memory", static_cast<int>(ExitCode::Machine));
}

/// What threads throw comes here, and what is thrown while there is no memory to throw it.
void endInOneLine() {
    try {
        if (const auto error = std::current_exception()) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        noMemory();
    } catch (const std::system_error&) {
        noMemory();
    } catch (const std::exception& error) {
        Terminal::lastWord(error.what(), static_cast<int>(ExitCode::Internal));
    }
    Terminal::lastWord("internal error", static_cast<int>(ExitCode::Internal));
}

/// What the system says of a folder or a link.
std::string said(const std::filesystem::filesystem_error& error) {
    const char* folder = std::getenv("TMPDIR");
    const std::string place = error.path1().string();
    if (folder && (place.empty() || place == folder))
        return std::string(folder) + ": cannot take the temporary files (TMPDIR): " + error.code().message();
    return place + ": " + error.code().message();
}

/// Runs, and turns whatever is thrown into its one line and exit code.
ExitCode guarded(const std::function<ExitCode()>& run) try { return run(); } catch (const UsageError& error) {
    Terminal::error(error.what());
    return ExitCode::Usage;
} catch (const DiskFull& error) {
    Terminal::error(messageOf(error));
    return ExitCode::Machine;
} catch (const InputError& error) {
    Terminal::error(messageOf(error));
    return ExitCode::Input;
} catch (const Cancelled&) {
    Terminal::error(kCancelled);
    return ExitCode::Incomplete;
} catch (const std::filesystem::filesystem_error& error) {
    Terminal::error(said(error));
    return error.code() == std::errc::no_space_on_device ? ExitCode::Machine : ExitCode::Input;
} catch (const OutOfMemory& error) {
    Terminal::error(error.what());
    return ExitCode::Machine;
} catch (const std::bad_alloc&) {
    noMemory();
} catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) noMemory();  // a thread
    Terminal::error("internal error: " + std::string(error.what()));
    return ExitCode::Internal;
} catch (const std::exception& error) {
    Terminal::error("internal error: " + std::string(error.what()));
    return ExitCode::Internal;
}

}  // namespace

ExitCode print(const std::string& text) {
    const bool written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
    if (!written) throw InputError("-", "standard output cannot be written");
    return ExitCode::Done;
}

std::string onlyFile(const Arguments& arguments, const std::string& what) {
    if (arguments.files().empty()) throw UsageError("no " + what + " is named");
    if (arguments.files().size() > 1)
        throw UsageError("only one " + what + " can be named, but there is also " + arguments.files()[1]);
    Terminal::setFile(arguments.files()[0]);
    return arguments.files()[0];
}

bool isCommand(const std::string& word) {
    if (word.starts_with("--") || word == "-h" || findCommand(word)) return true;
    if (word.starts_with("-")) return false;  // -platform, -style …: the window's
    std::error_code error;
    return word.find_first_of("./") == std::string::npos && !std::filesystem::exists(word, error);
}

int runCommand(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error like a full disk
    std::set_terminate(endInOneLine);
    const std::vector<std::string> words(argv + 1, argv + argc);
    const ExitCode code = guarded([&] { return dispatch(words); });
    // Not exit(): the libraries wait there for threads that, without memory, never began.
    std::fflush(nullptr);
    _exit(static_cast<int>(code));
}

}  // namespace wend
