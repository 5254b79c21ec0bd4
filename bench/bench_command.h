#pragma once

#include "app/cli/arguments.h"
#include "app/cli/cli.h"

namespace wend {

/// Measures what the arguments of `wend bench` ask for, prints each result as soon as it is there, and at the
/// end the table. Throws UsageError, InputError and Cancelled.
ExitCode runBench(const Arguments& arguments);

}  // namespace wend
