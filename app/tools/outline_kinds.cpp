// How the window offers the tools that draw the outline.
#include <QCoreApplication>

#include "app/tools/outline_tool.h"

namespace wend {

namespace {

template <OutlineTool::Shape Shape>
ToolMakers makers() {
    return picturesOnly(
        [](Workbench& on) { return std::make_unique<OutlineTool>(on.picture, Shape, on.pen); });
}

}  // namespace

ToolKind outlineLassoTool() {
    return {.id = "outlineLasso",
            .icon = "area-lasso",
            .name = QT_TRANSLATE_NOOP("Tools", "Outline by &Lasso"),
            .help = QT_TRANSLATE_NOOP("Tools", "Draw around what shall bend, or shall not"),
            .keys = "L",
            .modes = Mode::Mesh,
            .make = makers<OutlineTool::Shape::Lasso>(),
            .options = {ToolOption::AddsOrTakes}};
}

ToolKind outlinePolygonTool() {
    return {.id = "outlinePolygon",
            .icon = "outline-polygon",
            .name = QT_TRANSLATE_NOOP("Tools", "Outline by &Polygon"),
            .help = QT_TRANSLATE_NOOP("Tools", "Set the corners of what shall bend, or shall not"),
            .keys = "Shift+L",
            .modes = Mode::Mesh,
            .make = makers<OutlineTool::Shape::Polygon>(),
            .options = {ToolOption::AddsOrTakes}};
}

ToolKind outlineBrushTool() {
    return {.id = "outlineBrush",
            .icon = "outline-brush",
            .name = QT_TRANSLATE_NOOP("Tools", "Outline by &Brush"),
            .help = QT_TRANSLATE_NOOP("Tools", "Brush over what shall bend, or shall not"),
            .keys = "B",
            .modes = Mode::Mesh,
            .make = makers<OutlineTool::Shape::Brush>(),
            .options = {ToolOption::AddsOrTakes, ToolOption::PenSize}};
}

ToolKind outlineWandTool() {
    return {.id = "wand",
            .icon = "outline-wand",
            .name = QT_TRANSLATE_NOOP("Tools", "Outline by &Colour"),
            .help = QT_TRANSLATE_NOOP("Tools", "Click on a colour that shall bend, or shall not"),
            .keys = "W",
            .modes = Mode::Mesh,
            .make = makers<OutlineTool::Shape::Wand>(),
            .options = {ToolOption::AddsOrTakes, ToolOption::Tolerance}};
}

ToolKind cutStrokeTool() {
    return {.id = "cutStroke",
            .icon = "outline-cut",
            .name = QT_TRANSLATE_NOOP("Tools", "Cut &Apart"),
            .help = QT_TRANSLATE_NOOP("Tools", "Draw a line along which the shape is parted"),
            .keys = "X",
            .modes = Mode::Mesh,
            .make = makers<OutlineTool::Shape::Cut>()};
}

}  // namespace wend
