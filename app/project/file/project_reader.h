#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/project/project_fwd.h"

namespace wend {

/// A loaded project with messages for the user.
struct LoadedProject {
    std::shared_ptr<Project> project;
    std::vector<std::string> warnings;  // unknown keys …
};

/// Throws InputError(path, reason with line or key such as `handles[2].motion[0].points`). The dimension is
/// that of the domain; the file of a mesh domain is opened for it, and if that fails, coordinates decide
/// (building the shape reports the file).
LoadedProject readProject(const std::string& path);
LoadedProject parseProject(const std::string& text, const std::string& path);

}  // namespace wend
