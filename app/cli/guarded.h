#pragma once

#include <functional>

#include "app/cli/cli.h"

namespace wend {

/// Runs, turns any exception into its one line and exit code, calls `finish` and ends the process. An
/// exception for lack of memory ends it at once.
int runToTheEnd(const std::function<ExitCode()>& run, const std::function<void()>& finish = {});

}  // namespace wend
