#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/document/project_fwd.h"
#include "core/motion/handle.h"

namespace wend {

/// What the list of pins changes about handles, none of which moves the shape.

const HandleTraits& traitsOf(const AnyDesign& design, int handle);
/// The same change of several handles.
AnyDesign withTraits(const AnyDesign& design, const std::vector<int>& handles,
                     const std::function<void(HandleTraits&)>& change);

/// These handles and all that are linked with one of them, increasing.
std::vector<int> withLinked(const AnyDesign& design, std::vector<int> handles);
bool isLinked(const AnyDesign& design, int handle);
/// From now on they move together, with all that was linked with one of them.
AnyDesign withLink(const AnyDesign& design, const std::vector<int>& handles);
/// Each of them moves alone, and so does one that is left of its link.
AnyDesign withoutLink(const AnyDesign& design, const std::vector<int>& handles);

/// The groups in the order of their first handles.
std::vector<std::string> groupNames(const AnyDesign& design);
std::vector<int> handlesOfGroup(const AnyDesign& design, const std::string& group);

}  // namespace wend
