#pragma once

#include <string>
#include <vector>

#include "app/output/run.h"

namespace wend {

/// A file that a project is read from.
enum class OwnFile { Project, Picture, Mesh, Sizes, Detail, Material, Look, States, Motion, Points, Audio };

struct OwnInput {
    OwnFile kind;
    std::string path;
};

/// Returns the files that a project is read from: its own, `path`, and all that it names, relative to
/// `folder`, with those that a surface in turn names.
std::vector<OwnInput> inputsOf(const Project& project, const std::string& path, const std::string& folder);

/// "OUTPUT: would replace INPUT, which is read here", or another output; empty if each has a place of its
/// own. Names are compared as sameFile() does; what is no regular file replaces nothing.
std::string overwriting(const std::vector<OwnInput>& inputs, const RunOutputs& outputs);

}  // namespace wend
