#pragma once

#include <stop_token>
#include <string>

namespace wend {

/// How a child process ended, and what it wrote.
struct ChildResult {
    /// Idle: it was killed because its process group used no CPU time. Stopped: it was killed on request.
    enum class End { Exited, Signalled, TimedOut, Idle, Stopped, NotStarted };
    End end = End::Exited;
    int code = 0;        // exit code or signal
    std::string output;  // its standard output
};

/// Runs the program at `path` with `input` on its standard input until it ends, `seconds` have passed or a
/// stop is requested (then its process group is killed). Its arguments are the memory limit in megabytes and,
/// if given, the limit of CPU seconds, which it must set for itself. If `idleSeconds` are given, it is also
/// killed when its group has neither produced output nor used CPU time for that long, which distinguishes a
/// hang from slowness on a busy machine.
ChildResult runChild(const std::string& path, const std::string& input, double seconds, int megabytes,
                     const std::stop_token& stop, double processorSeconds = 0, double idleSeconds = 0);

/// Returns the path of an installed helper: beside this program, in ../lib/wend, or, for a library in another
/// program, near the library.
std::string siblingProgram(const std::string& name);

}  // namespace wend
