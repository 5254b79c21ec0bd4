#pragma once

#include <functional>

#include "app/cli/cli.h"

namespace wend {

/// Runs, turns whatever is thrown into its one line and exit code, calls `finish` and ends the process. What
/// is thrown for want of memory ends it at once.
int runToTheEnd(const std::function<ExitCode()>& run, const std::function<void()>& finish = {});

}  // namespace wend
