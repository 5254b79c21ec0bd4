#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/document/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// What the list of pins changes about handles, none of which moves the shape.

const HandleTraits& traitsOf(const Project& project, int handle);
/// The same change of several handles.
Project withTraits(const Project& project, const std::vector<int>& handles,
                   const std::function<void(HandleTraits&)>& change);

/// These handles and all that are linked with one of them, increasing.
std::vector<int> withLinked(const Project& project, std::vector<int> handles);
bool isLinked(const Project& project, int handle);
/// From now on they move together, with all that was linked with one of them.
Project withLink(const Project& project, const std::vector<int>& handles);
/// Each of them moves alone, and so does one that is left of its link.
Project withoutLink(const Project& project, const std::vector<int>& handles);

/// The groups in the order of their first handles.
std::vector<std::string> groupNames(const Project& project);
std::vector<int> handlesOfGroup(const Project& project, const std::string& group);

}  // namespace wend
