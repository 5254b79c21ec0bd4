#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/document/project_fwd.h"

namespace wend {

/// A loaded project and what the user should hear about it.
struct LoadedProject {
    std::shared_ptr<Project> project;
    std::vector<std::string> warnings;  // unknown keys …
};

/// Throws InputError(path, reason with line or key such as `handles[2].motion[0].points`). The dimension is
/// that of the domain; a mesh domain's file is opened for it, and if that fails the coordinates tell (the
/// scene reports the file).
LoadedProject readProject(const std::string& path);
LoadedProject parseProject(const std::string& text, const std::string& path);

}  // namespace wend
