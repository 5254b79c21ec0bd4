#pragma once

#include <functional>
#include <string>

namespace wend {

struct RunSolvers;

/// Exit codes of the command line. Machine: it has not the memory or the disk that is needed.
enum class ExitCode { Done = 0, Internal = 1, Usage = 2, Input = 3, Incomplete = 4, Machine = 5 };

/// Returns whether the word after the program's name asks for a subcommand, help or version, and not for the
/// window.
bool isCommand(const std::string& word);

/// Runs a subcommand; needs no display. Returns the exit code.
int runCommand(int argc, char** argv);

/// Runs the program of many processes in the first of them: `run` alone, with these solvers. `finish` is
/// called before the process ends. Returns the exit code.
int runDividedCommand(int argc, char** argv, const RunSolvers& solvers, const std::function<void()>& finish);

}  // namespace wend
