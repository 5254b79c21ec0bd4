#pragma once

#include "app/cli/arguments.h"
#include "app/cli/cli.h"

namespace wend {

struct RunSolvers;

ExitCode runRun(const Arguments& arguments);
/// Does the same by multigrid with these solvers.
ExitCode runDivided(const Arguments& arguments, const RunSolvers& solvers);
ExitCode runMesh(const Arguments& arguments);
ExitCode runConvert(const Arguments& arguments);
ExitCode runInfo(const Arguments& arguments);
ExitCode runDevices(const Arguments& arguments);
/// Becomes the program wend-bench. Throws InputError if that is not there.
ExitCode startBench(const Arguments& arguments);
/// Prints the reference page of the options (docs/reference.md) or a shell's completion, or writes the manual
/// pages.
ExitCode runReference(const Arguments& arguments);

/// Prints on standard output. Throws InputError if that is full or closed.
ExitCode print(const std::string& text);

/// The message about work that was cancelled.
inline constexpr const char* kCancelled = "cancelled; nothing was written";

/// Returns the only file on the line; throws UsageError if there is none or there are several.
std::string onlyFile(const Arguments& arguments, const std::string& what);
/// Throws UsageError if a path stands for standard input.
void requireFile(const std::string& path);

}  // namespace wend
