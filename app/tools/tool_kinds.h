#pragma once

#include "app/tools/tool_kind.h"

namespace wend {

/// The tools whose classes nothing else needs, for the table of tools.
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
