#pragma once

#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "app/output/run.h"
#include "app/project/project_fwd.h"

namespace wend {

/// Returns the options of a command line of `wend run`. Throws UsageError.
RunOptions runOptionsOf(const Arguments& arguments);

/// Lets the line win over what the project says that was read from `path`, and checks that both fit. Returns
/// notices. Throws UsageError and InputError.
std::vector<std::string> takeLine(const Arguments& arguments, const std::string& path, RunOptions& options,
                                  Project& project);

}  // namespace wend
