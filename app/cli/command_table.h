#pragma once

#include <span>
#include <string>

#include "app/cli/commands.h"

namespace wend {

/// A subcommand, as help, manual pages and completion describe it.
struct Command {
    const char* name;
    const char* usage;  // what follows the name
    const char* meaning;
    ExitCode (*run)(const Arguments&);
    bool hidden = false;  // from the overview: for developers
};

/// Returns all subcommands, in the order of the overview.
std::span<const Command> commands();
/// Returns null if there is none of that name.
const Command* findCommand(const std::string& name);
/// Returns remarks beyond the options; empty for most commands.
std::string remarksOn(const Command& command);
/// Describes the exit codes.
std::string exitCodeText();

}  // namespace wend
