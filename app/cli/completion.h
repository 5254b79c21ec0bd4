#pragma once

#include <string>

namespace wend {

/// The script that completes the program's command line in "bash", "zsh" or "fish", from the tables of
/// subcommands and options: commands, options, choices and file names.
std::string completionFor(const std::string& shell);

}  // namespace wend
