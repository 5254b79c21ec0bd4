#pragma once

#include <string>
#include <vector>

#include "app/project/project_fwd.h"

namespace wend {

/// UTF-8 JSON, written whole or not at all. The domain's relative paths refer to `folder` (empty: the folder
/// of `path`) and are written relative to `path`. readProject of the result is the same project. Throws
/// InputError.
void writeProject(const std::string& path, const Project& project, const std::string& folder = {});
std::string toJson(const Project& project);

/// Returns pointers to the file names in a project.
std::vector<std::string*> filesOf(Project& project);

}  // namespace wend
