#include "app/window/actions/tool_table.h"

#include "app/tools/measure_tool.h"
#include "app/tools/mesh/outline_tool.h"
#include "app/tools/mesh/size_tool.h"
#include "app/tools/paint/depth_tool.h"
#include "app/tools/paint/paint_tool.h"
#include "app/tools/pins/pin_tool.h"
#include "app/tools/tool_kinds.h"

namespace wend {

const std::vector<ToolKind>& toolTable() {
    static const std::vector<ToolKind> table = {
        pinTool(),          selectTool(),         penTool(),
        grabByLassoTool(),  grabByBoxTool(),      grabByBrushTool(),
        grabBallTool(),     grabBlockTool(),      grabSideTool(),
        outlineLassoTool(), outlinePolygonTool(), outlineBrushTool(),
        outlineWandTool(),  cutStrokeTool(),      detailBrushTool(),
        paintTool(),        combTool(),           gradientTool(),
        fillTool(),         eyedropperTool(),     eraserTool(),
        depthTool(),        measureTool(),        cropTool(),
        panTool(),
    };
    return table;
}

}  // namespace wend
