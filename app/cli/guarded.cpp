#include "app/cli/guarded.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/base/input_file.h"
#include "core/base/last_act.h"
#include "core/base/printable.h"
#include "core/base/safe_file.h"

namespace wend {
namespace {

[[noreturn]] void noMemory() {
    Terminal::lastWord("there is not enough memory", static_cast<int>(ExitCode::Machine));
}

/// Ends the program with one line for exceptions that leave a thread, or that no memory is left to throw.
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

/// Returns the message for an error of a folder or a link.
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
    Terminal::error(messageOf(error).text());
    return ExitCode::Machine;
} catch (const InputError& error) {
    Terminal::error(messageOf(error).text());
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

void requireFile(const std::string& path) {
    if (path == "-") throw UsageError("-: only `wend run` reads standard input; name a file");
}

int runToTheEnd(const std::function<ExitCode()>& run, const std::function<void()>& finish) {
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error like a full disk
    std::set_terminate(endInOneLine);
    const ExitCode code = guarded(run);
    if (finish) finish();
    // Not exit(): the libraries wait there for threads that, without memory, never began.
    std::fflush(nullptr);
    endProcess(static_cast<int>(code));
}

}  // namespace wend
