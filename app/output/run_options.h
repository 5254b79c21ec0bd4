#pragma once

#include "app/output/run.h"
#include "app/project/options/option_values.h"

namespace wend {

struct WarpOptions;

/// Returns how outputs are made, from the options of the command line or of a dialog, but not which outputs,
/// and up to what time.
RunOptions runOptionsFrom(const OptionValues& values);
MeshWriteOptions meshOptionsFrom(const OptionValues& values);

/// Returns the options of warping a picture of that project.
WarpOptions warpOptionsOf(const Project& project, const RunOptions& options);

/// Throws InputError for a depth that the format of this picture does not hold.
void requireDepth(const std::string& path, const RunOptions& options);

/// Throws InputError for parts of a picture that are to be continued outside them.
void requireNothingOutside(const Project& project, const RunOptions& options);

}  // namespace wend
