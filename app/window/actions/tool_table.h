#pragma once

#include "app/tools/tool_kind.h"

namespace wend {

/// Returns all tools in the order of the tool bar.
const std::vector<ToolKind>& toolTable();

}  // namespace wend
