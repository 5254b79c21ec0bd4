#include "app/view/tool_table.h"

#include "app/tools/crop_tool.h"
#include "app/tools/depth_tool.h"
#include "app/tools/fill_tool.h"
#include "app/tools/grab_tool.h"
#include "app/tools/gradient_tool.h"
#include "app/tools/measure_tool.h"
#include "app/tools/outline_tool.h"
#include "app/tools/paint_tool.h"
#include "app/tools/pan_tool.h"
#include "app/tools/pen_tool.h"
#include "app/tools/pin_tool.h"
#include "app/tools/region_tool.h"
#include "app/tools/size_tool.h"

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
