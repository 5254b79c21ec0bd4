#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/engine/measure.h"
#include "app/session/crop.h"
#include "app/tools/mode.h"
#include "app/tools/outline_settings.h"
#include "app/tools/pin_settings.h"
#include "app/tools/shape_tool.h"

namespace wend {

class Brush;

/// The objects that tools work on.
struct Workbench {
    PictureShapeView* picture;
    SolidShapeView* solid;  // null before the first solid
    Brush* brush;
    PinChoice* pins;
    OutlinePen* pen;
    Crop* crop;
    std::function<void()> toSelect;  // a part was taken hold of, and is there to be moved
};

/// Factories of a tool for pictures and solids; empty if it does not support them.
struct ToolMakers {
    using Make = std::function<std::unique_ptr<Tool>(const Workbench&)>;
    Make picture = {}, solid = {};

    const Make& of(int dimension) const { return dimension == 3 ? solid : picture; }
};

/// Returns a constructor argument of a tool: a value, or a member such as &Workbench::brush.
template <class Part>
const Part& partOf(const Workbench&, const Part& part) {
    return part;
}
template <class Part>
Part& partOf(const Workbench& on, Part* Workbench::*part) {
    return *(on.*part);
}
inline std::function<void()> partOf(const Workbench& on, std::function<void()> Workbench::*part) {
    return on.*part;
}
template <class OneTool, class View, class... Parts>
ToolMakers::Make maker(View view, Parts... parts) {
    return [=](const Workbench& on) {
        return std::make_unique<OneTool>(partOf(on, view), partOf(on, parts)...);
    };
}

/// Makes a tool whose constructor takes the view and these parts.
template <class OneTool, class... Parts>
ToolMakers both(Parts... parts) {
    return {maker<OneTool>(&Workbench::picture, parts...), maker<OneTool>(&Workbench::solid, parts...)};
}
template <class OneTool, class... Parts>
ToolMakers picturesOnly(Parts... parts) {
    return {.picture = maker<OneTool>(&Workbench::picture, parts...)};
}
template <class OneTool, class... Parts>
ToolMakers solidsOnly(Parts... parts) {
    return {.solid = maker<OneTool>(&Workbench::solid, parts...)};
}

/// Options that can be shown beside a tool's name.
enum class ToolOption {
    Grip,      // effect of a drag on pins
    SelectBy,  // shape of the marquee
    Through,   // includes covered parts
    Snap,
    AddsOrTakes,  // adds or subtracts
    PenSize,
    Tolerance,
    Edges,
    Target,  // property that the brush changes
    BrushSize,
    GrabSize,
    Tip,  // size, hardness, amount, pressure
    Order,
    Separator
};

/// The definition of a tool for pictures and solids, from which tool bar, options, menus, shortcuts and the
/// cheat sheet follow. Each tool has its definition beside its class.
struct ToolKind {
    const char* id;
    const char* icon;
    const char *name, *help;  // in English, of the context "Tools"
    const char* keys;         // several with "; "
    Modes modes;
    ToolMakers make;
    std::vector<ToolOption> options;
    /// The map that is shown while the tool is active; empty or nothing: the user's choice.
    std::function<std::optional<Measure>(const Workbench&, int dimension)> map;
    Modes begins;  // those that begin with it; others begin with the tool that selects
};
inline ToolKind toolKind(const char* id, const char* icon, const char* name, const char* help,
                         const char* keys, Modes modes, ToolMakers make, std::vector<ToolOption> options = {},
                         decltype(ToolKind::map) map = {}, Modes begins = {}) {
    return {id, icon, name, help, keys, modes, std::move(make), std::move(options), std::move(map), begins};
}

}  // namespace wend
