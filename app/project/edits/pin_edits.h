#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/project/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// Edits of the pin list, none of which moves the shape.

const HandleTraits& traitsOf(const AnyDesign& design, int handle);
/// Does the same for several handles.
AnyDesign withTraits(const AnyDesign& design, const std::vector<int>& handles,
                     const std::function<void(HandleTraits&)>& change);

/// These handles and all that are linked with one of them, increasing.
std::vector<int> withLinked(const AnyDesign& design, std::vector<int> handles);
bool isLinked(const AnyDesign& design, int handle);
/// Links the handles, and everything that was linked to them, to move together.
AnyDesign withLink(const AnyDesign& design, const std::vector<int>& handles);
/// Unlinks each of them, and a single remaining partner.
AnyDesign withoutLink(const AnyDesign& design, const std::vector<int>& handles);

/// Return the groups in the order of their first handles, and the handles of one.
std::vector<std::string> groupNames(const AnyDesign& design);
std::vector<int> handlesOfGroup(const AnyDesign& design, const std::string& group);

}  // namespace wend
