#pragma once

#include "app/tools/tool_kind.h"

namespace wend {

/// Return the tools whose classes nothing but the table of tools needs.
ToolKind panTool();
ToolKind cropTool();
ToolKind penTool();
ToolKind gradientTool();
ToolKind fillTool();
ToolKind eyedropperTool();
ToolKind grabByLassoTool();
ToolKind grabByBoxTool();
ToolKind grabByBrushTool();
ToolKind grabBallTool();
ToolKind grabBlockTool();
ToolKind grabSideTool();

}  // namespace wend
