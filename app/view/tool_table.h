#pragma once

#include <QAction>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/panels/colour_map.h"
#include "app/session/crop.h"
#include "app/tools/shape_tool.h"
#include "app/view/mode.h"
#include "app/view/tool_options.h"

namespace wend {

class Brush;
class PictureActions;
class PinActions;
class SizePanel;
class SolidActions;

/// What tools work on and with.
struct Workbench {
    ToolSurface& picture;
    const SolidActions& actions;
    PictureActions& flat;
    const PinActions& pins;
    Brush& brush;
    Crop& crop;
    SizePanel& sizes;
    std::function<void()> toSelect;  // a part was taken hold of, and is there to be moved
    SolidSurface* solid = nullptr;   // none before the first solid
};

/// A tool of the window, once for all: tool bar, options, menus, keys and the cheat sheet come from this.
struct ToolKind {
    const char* id;
    const char* icon;
    const char *name, *help;  // in English, of the context "Tools"
    const char* keys;         // several with "; "
    Modes modes;
    Modes begins;  // those that begin with it; others begin with the tool that selects
    /// How it is made for pictures and for solids; null where it does nothing.
    std::unique_ptr<Tool> (*picture)(Workbench&);
    std::unique_ptr<Tool> (*solid)(Workbench&);
    /// What stands beside its name; null: nothing.
    QList<QAction*> (*options)(const ToolOptions&) = nullptr;
    /// What is coloured over the shape while it is chosen; null or nothing: what the user has chosen.
    std::optional<Measure> (*map)(const Workbench&, int dimension) = nullptr;
};

/// In the order of the tool bar.
const std::vector<ToolKind>& toolTable();

}  // namespace wend
