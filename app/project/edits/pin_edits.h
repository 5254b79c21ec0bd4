#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/project/pin.h"
#include "app/project/project_fwd.h"

namespace wend {

/// Edits of the pin list, none of which moves the shape.

const PinTraits& traitsOf(const Design& design, int handle);
/// Does the same for several handles.
Design withTraits(const Design& design, const std::vector<int>& handles,
                  const std::function<void(PinTraits&)>& change);

/// These handles and all that are linked with one of them, increasing.
std::vector<int> withLinked(const Design& design, std::vector<int> handles);
bool isLinked(const Design& design, int handle);
/// Links the handles, and everything that was linked to them, to move together.
Design withLink(const Design& design, const std::vector<int>& handles);
/// Unlinks each of them, and a single remaining partner.
Design withoutLink(const Design& design, const std::vector<int>& handles);

/// Return the groups in the order of their first handles, and the handles of one.
std::vector<std::string> groupNames(const Design& design);
std::vector<int> handlesOfGroup(const Design& design, const std::string& group);

}  // namespace wend
