#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/session/measure.h"
#include "app/session/run/crop.h"
#include "app/tools/mode.h"
#include "app/tools/outline_settings.h"
#include "app/tools/pin_settings.h"
#include "app/tools/shape_tool.h"

namespace wend {

class Brush;

/// What tools work on and with.
struct Workbench {
    ToolSurface* picture;
    SolidSurface* solid;  // null before the first solid
    Brush* brush;
    PinChoice* pins;
    OutlinePen* pen;
    Crop* crop;
    std::function<void()> toSelect;  // a part was taken hold of, and is there to be moved
};

/// How a tool is made for pictures and for solids; empty where it does nothing.
struct ToolMakers {
    using Make = std::function<std::unique_ptr<Tool>(const Workbench&)>;
    Make picture = {}, solid = {};

    const Make& of(int dimension) const { return dimension == 3 ? solid : picture; }
};

/// What a tool is made of besides its surface: a value, or what stands on the workbench, as
/// &Workbench::brush.
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
template <class OneTool, class Surface, class... Parts>
ToolMakers::Make maker(Surface surface, Parts... parts) {
    return [=](const Workbench& on) {
        return std::make_unique<OneTool>(partOf(on, surface), partOf(on, parts)...);
    };
}

/// A tool whose constructor takes the surface and these parts.
template <template <int> class ToolOf, class... Parts>
ToolMakers both(Parts... parts) {
    return {maker<ToolOf<2>>(&Workbench::picture, parts...), maker<ToolOf<3>>(&Workbench::solid, parts...)};
}
template <class OneTool, class... Parts>
ToolMakers picturesOnly(Parts... parts) {
    return {.picture = maker<OneTool>(&Workbench::picture, parts...)};
}
template <class OneTool, class... Parts>
ToolMakers solidsOnly(Parts... parts) {
    return {.solid = maker<OneTool>(&Workbench::solid, parts...)};
}

/// What may stand beside a tool's name.
enum class ToolOption {
    Grip,      // what a drag does with pins
    SelectBy,  // what is drawn beside pins
    Through,   // takes what is hidden, too
    Snap,
    AddsOrTakes,  // what is drawn will bend, or not
    PenSize,
    Tolerance,
    Edges,
    Target,  // what the brush changes
    BrushSize,
    GrabSize,
    Tip,  // size, hardness, amount, pressure
    Order,
    Separator
};

/// A tool of the window, for pictures and solids: tool bar, options, menus, keys and the cheat sheet come
/// from this. Each tool says it beside its class.
struct ToolKind {
    const char* id;
    const char* icon;
    const char *name, *help;  // in English, of the context "Tools"
    const char* keys;         // several with "; "
    Modes modes;
    ToolMakers make;
    std::vector<ToolOption> options;
    /// What is coloured over the shape while it is chosen; empty or nothing: what the user has chosen.
    std::function<std::optional<Measure>(const Workbench&, int dimension)> map;
    Modes begins;  // those that begin with it; others begin with the tool that selects
};
inline ToolKind toolKind(const char* id, const char* icon, const char* name, const char* help,
                         const char* keys, Modes modes, ToolMakers make, std::vector<ToolOption> options = {},
                         decltype(ToolKind::map) map = {}, Modes begins = {}) {
    return {id, icon, name, help, keys, modes, std::move(make), std::move(options), std::move(map), begins};
}

}  // namespace wend
