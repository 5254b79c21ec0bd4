#pragma once

#include <string>

namespace wend {

/// Exit codes of the command line. Machine: it has not the memory or the disk that is needed.
enum class ExitCode { Done = 0, Internal = 1, Usage = 2, Input = 3, Incomplete = 4, Machine = 5 };

/// Whether the word after the program's name asks for a subcommand, help or version, and not for the window.
bool isCommand(const std::string& word);

/// Runs a subcommand; needs no display. Returns the exit code.
int runCommand(int argc, char** argv);

}  // namespace wend
