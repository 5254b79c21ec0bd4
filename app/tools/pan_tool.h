#pragma once

#include "app/tools/tool_kind.h"

namespace wend {

ToolKind panTool();

}  // namespace wend
