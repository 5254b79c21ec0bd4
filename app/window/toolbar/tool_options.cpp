#include "app/window/toolbar/tool_options.h"

#include <QWidgetAction>

#include "app/window/actions/brush_actions.h"
#include "app/window/actions/picture_actions.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/actions/solid_actions.h"

namespace wend {

QList<QAction*> ToolOptions::of(const ToolKind& kind) const {
    QList<QAction*> all;
    for (const ToolOption option : kind.options) all << of(option);
    return all;
}

QList<QAction*> ToolOptions::of(ToolOption option) const {
    switch (option) {
        case ToolOption::Grip:
            return {pins.move, pins.turn, pins.grow};
        case ToolOption::SelectBy:
            return {pins.selectRectangle, pins.selectLasso, pins.selectBrush};
        case ToolOption::Through:
            return {solids.through};
        case ToolOption::Snap:
            return {pins.snap};
        case ToolOption::AddsOrTakes:
            return {outline.adds, outline.takesAway, outline.makesPart};
        case ToolOption::PenSize:
            return {outline.size};
        case ToolOption::Tolerance:
            return {outline.tolerance};
        case ToolOption::Edges:
            return {brush.edges};
        case ToolOption::Target:
            return {brush.keep, brush.stiffness, brush.direction};
        case ToolOption::BrushSize:
            return {brush.size};
        case ToolOption::GrabSize:
            return {pins.brushSize};
        case ToolOption::Tip:
            return {brush.size, brush.hardness, brush.amount, brush.pressure};
        case ToolOption::Order:
            return {brush.order};
        case ToolOption::Separator:
            break;
    }
    return {nullptr};
}

}  // namespace wend
