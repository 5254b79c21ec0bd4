#pragma once

#include <stop_token>
#include <string>

namespace wend {

struct ChildResult {
    enum class End { Exited, Signalled, TimedOut, Idle, Stopped, NotStarted };
    End end = End::Exited;
    int code = 0;        // exit code or signal
    std::string output;  // what it wrote to standard output
};

/// Runs the program at `path` with `input` on its standard input until it ends, `seconds` have passed or a
/// stop is asked for (then it is killed, with what it has started). Its arguments are the largest memory in
/// megabytes and, if they are given, the seconds of the processor's time that it may use: limits that it has
/// to set for itself. If `idleSeconds` are given, it is killed too when neither it nor what it has started
/// has said or computed anything for so long: on a busy machine that tells a hang from slowness.
ChildResult runChild(const std::string& path, const std::string& input, double seconds, int megabytes,
                     const std::stop_token& stop, double processorSeconds = 0, double idleSeconds = 0);

/// A file that came with this program: beside it, or where it is installed, in ../lib/wend.
std::string siblingProgram(const std::string& name);

}  // namespace wend
