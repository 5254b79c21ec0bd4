#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/session/crop.h"
#include "app/session/measure.h"
#include "app/tools/mode.h"
#include "app/tools/outline_settings.h"
#include "app/tools/pin_settings.h"
#include "app/tools/shape_tool.h"

namespace wend {

class Brush;

/// What tools work on and with.
struct Workbench {
    ToolSurface& picture;
    SolidSurface* solid;  // null before the first solid
    Brush& brush;
    PinChoice& pins;
    OutlinePen& pen;
    Crop& crop;
    std::function<void()> toSelect;  // a part was taken hold of, and is there to be moved

    template <int Dim>
    SurfaceOf<Dim>& surface() const {
        if constexpr (Dim == 2)
            return picture;
        else
            return *solid;
    }
};

/// How a tool is made for pictures and for solids; empty where it does nothing.
struct ToolMakers {
    using Make = std::function<std::unique_ptr<Tool>(Workbench&)>;
    Make picture = {}, solid = {};

    const Make& of(int dimension) const { return dimension == 3 ? solid : picture; }
};

/// `make` is a template over the dimension.
template <class Make>
ToolMakers both(Make make) {
    return {[make](Workbench& on) { return make.template operator()<2>(on); },
            [make](Workbench& on) { return make.template operator()<3>(on); }};
}
inline ToolMakers picturesOnly(ToolMakers::Make make) {
    return {.picture = std::move(make)};
}
inline ToolMakers solidsOnly(ToolMakers::Make make) {
    return {.solid = std::move(make)};
}

/// What may stand beside a tool's name.
enum class ToolOption {
    Grip,      // what a drag does with pins
    SelectBy,  // what is drawn beside pins
    Through,   // takes what is hidden, too
    Snap,
    AddsOrTakes,  // what is drawn shall bend, or not
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
    const char* id = nullptr;
    const char* icon = nullptr;
    const char *name = nullptr, *help = nullptr;  // in English, of the context "Tools"
    const char* keys = nullptr;                   // several with "; "
    Modes modes = {};
    Modes begins = {};  // those that begin with it; others begin with the tool that selects
    ToolMakers make = {};
    std::vector<ToolOption> options = {};
    /// What is coloured over the shape while it is chosen; empty or nothing: what the user has chosen.
    std::function<std::optional<Measure>(const Workbench&, int dimension)> map = {};
};

}  // namespace wend
