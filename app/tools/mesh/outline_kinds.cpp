// The entries of the outline tools in the window.
#include <QCoreApplication>

#include "app/tools/mesh/outline_tool.h"

namespace wend {

ToolKind outlineLassoTool() {
    return toolKind("outlineLasso", "area-lasso", QT_TRANSLATE_NOOP("Tools", "Outline by &Lasso"),
                    QT_TRANSLATE_NOOP("Tools", "Draw around what should bend, or should not"), "L",
                    Mode::Mesh, picturesOnly<OutlineTool>(OutlineTool::Shape::Lasso, &Workbench::pen),
                    {ToolOption::AddsOrTakes});
}

ToolKind outlinePolygonTool() {
    return toolKind("outlinePolygon", "outline-polygon", QT_TRANSLATE_NOOP("Tools", "Outline by &Polygon"),
                    QT_TRANSLATE_NOOP("Tools", "Set the corners of what should bend, or should not"),
                    "Shift+L", Mode::Mesh,
                    picturesOnly<OutlineTool>(OutlineTool::Shape::Polygon, &Workbench::pen),
                    {ToolOption::AddsOrTakes});
}

ToolKind outlineBrushTool() {
    return toolKind("outlineBrush", "outline-brush", QT_TRANSLATE_NOOP("Tools", "Outline by &Brush"),
                    QT_TRANSLATE_NOOP("Tools", "Brush over what should bend, or should not"), "B", Mode::Mesh,
                    picturesOnly<OutlineTool>(OutlineTool::Shape::Brush, &Workbench::pen),
                    {ToolOption::AddsOrTakes, ToolOption::PenSize});
}

ToolKind outlineWandTool() {
    return toolKind("wand", "outline-wand", QT_TRANSLATE_NOOP("Tools", "Magic &Wand"),
                    QT_TRANSLATE_NOOP("Tools", "Click a colour that should bend, or should not"), "W",
                    Mode::Mesh, picturesOnly<OutlineTool>(OutlineTool::Shape::Wand, &Workbench::pen),
                    {ToolOption::AddsOrTakes, ToolOption::Tolerance});
}

ToolKind cutStrokeTool() {
    return toolKind("cutStroke", "outline-cut", QT_TRANSLATE_NOOP("Tools", "Cut &Apart"),
                    QT_TRANSLATE_NOOP("Tools", "Draw a line along which to part the shape"), "X", Mode::Mesh,
                    picturesOnly<OutlineTool>(OutlineTool::Shape::Cut, &Workbench::pen));
}

}  // namespace wend
