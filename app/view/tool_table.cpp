#include "app/view/tool_table.h"

#include "app/panels/size_panel.h"
#include "app/tools/area_tool.h"
#include "app/tools/crop_tool.h"
#include "app/tools/depth_tool.h"
#include "app/tools/fill_tool.h"
#include "app/tools/gradient_tool.h"
#include "app/tools/hold_tool.h"
#include "app/tools/measure_tool.h"
#include "app/tools/outline_tool.h"
#include "app/tools/paint_tool.h"
#include "app/tools/pan_tool.h"
#include "app/tools/pen_tool.h"
#include "app/tools/pin_tool.h"
#include "app/tools/size_tool.h"
#include "app/view/picture_actions.h"
#include "app/view/pin_actions.h"
#include "app/view/solid_actions.h"
#include "app/view/tool_options.h"

namespace wend {

namespace {

/// Does what a switch says, now and from then on.
template <class Take>
void follow(QAction* action, Take take) {
    take(action->isChecked());
    QObject::connect(action, &QAction::toggled, action, take);
}

/// What a switch of several chooses.
template <class Choice, class Take>
void followChoice(std::initializer_list<std::pair<QAction*, Choice>> choices, Take take) {
    for (const auto& [action, choice] : choices)
        follow(action, [take, choice = choice](bool chosen) {
            if (chosen) take(choice);
        });
}

template <int Dim>
SurfaceOf<Dim>& surfaceOf(Workbench& on) {
    if constexpr (Dim == 2)
        return on.picture;
    else
        return *on.solid;
}

template <int Dim, bool Adds>
std::unique_ptr<Tool> pins(Workbench& on) {
    auto tool = std::make_unique<PinTool<Dim>>(surfaceOf<Dim>(on), Adds);
    using Drawn = DrawnOutline::Kind;
    const PinActions& a = on.pins;
    followChoice<Grip::Kind>(
        {{a.move, Grip::Kind::Move}, {a.turn, Grip::Kind::Turn}, {a.grow, Grip::Kind::Grow}},
        [pins = tool.get()](Grip::Kind kind) { pins->setGrip(kind); });
    followChoice<Drawn>(
        {{a.selectRectangle, Drawn::Rectangle}, {a.selectLasso, Drawn::Lasso}, {a.selectBrush, Drawn::Brush}},
        [pins = tool.get()](Drawn outline) { pins->setOutline(outline); });
    if (Dim == 3)
        follow(on.actions.through, [pins = tool.get()](bool through) { pins->setThrough(through); });
    follow(Dim == 3 ? on.actions.snap : on.flat.snap,
           [pins = tool.get()](bool snaps) { pins->setSnaps(snaps); });
    return tool;
}

template <HoldTool::Shape Shape>
std::unique_ptr<Tool> hold(Workbench& on) {
    return std::make_unique<HoldTool>(on.picture, Shape, on.toSelect);
}

template <AreaTool::Shape Shape>
std::unique_ptr<Tool> area(Workbench& on) {
    auto tool = std::make_unique<AreaTool>(*on.solid, Shape);
    follow(on.actions.through, [area = tool.get()](bool through) { area->setThrough(through); });
    return tool;
}

template <int Dim>
std::unique_ptr<Tool> paint(Workbench& on) {
    return std::make_unique<PaintTool<Dim>>(surfaceOf<Dim>(on), on.brush, PaintTool<Dim>::Deed::Paint);
}

template <int Dim>
std::unique_ptr<Tool> eraser(Workbench& on) {
    return std::make_unique<PaintTool<Dim>>(surfaceOf<Dim>(on), on.brush, PaintTool<Dim>::Deed::Erase);
}

template <int Dim>
std::unique_ptr<Tool> gradient(Workbench& on) {
    return std::make_unique<GradientTool<Dim>>(surfaceOf<Dim>(on), on.brush);
}

template <int Dim>
std::unique_ptr<Tool> fill(Workbench& on) {
    return std::make_unique<FillTool<Dim>>(surfaceOf<Dim>(on), on.brush, FillTool<Dim>::Deed::Fill);
}

template <int Dim>
std::unique_ptr<Tool> eyedropper(Workbench& on) {
    return std::make_unique<FillTool<Dim>>(surfaceOf<Dim>(on), on.brush, FillTool<Dim>::Deed::Pick);
}

template <int Dim>
std::unique_ptr<Tool> sizeBrush(Workbench& on) {
    const auto factor = [&on] { return Dim == 2 ? on.flat.fineness().now() : on.sizes.brushFactor(); };
    auto brush = std::make_unique<SizeTool<Dim>>(surfaceOf<Dim>(on), on.brush, factor);
    if constexpr (Dim == 3)
        QObject::connect(&on.sizes, &SizePanel::chosen, &on.sizes,
                         [surface = on.solid, tool = brush.get()](const std::vector<Region<3>>& regions) {
                             tool->setShown(regions);
                             surface->redraw();
                         });
    return brush;
}

template <int Dim>
std::unique_ptr<Tool> measure(Workbench& on) {
    return std::make_unique<MeasureTool<Dim>>(surfaceOf<Dim>(on));
}

template <OutlineTool::Shape Shape>
std::unique_ptr<Tool> outline(Workbench& on) {
    return std::make_unique<OutlineTool>(on.picture, Shape, on.flat.pen());
}

template <int Dim>
std::unique_ptr<Tool> pen(Workbench& on) {
    return std::make_unique<PenTool<Dim>>(surfaceOf<Dim>(on));
}

template <int Dim>
std::unique_ptr<Tool> pan(Workbench& on) {
    return std::make_unique<PanTool<Dim>>(surfaceOf<Dim>(on));
}

std::unique_ptr<Tool> crop(Workbench& on) {
    return std::make_unique<CropTool>(on.picture, on.crop);
}

std::unique_ptr<Tool> depthBrush(Workbench& on) {
    return std::make_unique<DepthTool>(on.picture, on.brush, on.flat.depth());
}

std::optional<Measure> painted(const Workbench& on, int) {
    return on.brush.now().target == BrushTarget::Keep ? Measure::Phi : Measure::Stiffness;
}

std::optional<Measure> sizes(const Workbench&, int dimension) {
    return dimension == 3 ? std::optional(Measure::CellSize) : std::nullopt;
}

}  // namespace

const std::vector<ToolKind>& toolTable() {
    using Hold = HoldTool::Shape;
    using Area = AreaTool::Shape;
    using Draw = OutlineTool::Shape;
    static const std::vector<ToolKind> table = {
        {"pin", "pin", QT_TRANSLATE_NOOP("Tools", "&Pin"),
         QT_TRANSLATE_NOOP("Tools", "Set pins and drag them"), "P", Mode::Pins, Mode::Pins, pins<2, true>,
         pins<3, true>, pinOptions<true>},
        {"select",
         "select",
         QT_TRANSLATE_NOOP("Tools", "Se&lect"),
         QT_TRANSLATE_NOOP("Tools", "Select and drag pins without setting new ones"),
         "V",
         Modes::all(),
         {},
         pins<2, false>,
         pins<3, false>,
         pinOptions<false>},
        {"pen",
         "pen",
         QT_TRANSLATE_NOOP("Tools", "Pe&n"),
         QT_TRANSLATE_NOOP("Tools", "Draw the path of a pin, point by point"),
         "P",
         Mode::Animate,
         {},
         pen<2>,
         pen<3>},
        {"lasso",
         "area-lasso",
         QT_TRANSLATE_NOOP("Tools", "Grab by &Lasso"),
         QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a drawn outline as one handle"),
         "L",
         Mode::Pins,
         {},
         hold<Hold::Lasso>,
         area<Area::Lasso>,
         throughOptions},
        {"rectangle",
         "area-rectangle",
         QT_TRANSLATE_NOOP("Tools", "Grab by Bo&x"),
         QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a rectangle as one handle"),
         "Shift+B",
         Mode::Pins,
         {},
         hold<Hold::Rectangle>,
         area<Area::Rectangle>,
         throughOptions},
        {"grabBrush",
         "area-brush",
         QT_TRANSLATE_NOOP("Tools", "Grab by &Brush"),
         QT_TRANSLATE_NOOP("Tools", "Take hold of what is brushed over as one handle"),
         "U",
         Mode::Pins,
         {},
         hold<Hold::Brush>,
         area<Area::Brush>,
         throughOptions},
        {"ball",
         "area-ball",
         QT_TRANSLATE_NOOP("Tools", "Grab a B&all"),
         QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a ball around a point of the surface"),
         "Shift+K",
         Mode::Pins,
         {},
         nullptr,
         area<Area::Ball>},
        {"block",
         "area-box",
         QT_TRANSLATE_NOOP("Tools", "Grab a Bloc&k"),
         QT_TRANSLATE_NOOP("Tools", "Take hold of all that lies in a block around a point of the surface"),
         "Shift+X",
         Mode::Pins,
         {},
         nullptr,
         area<Area::Box>},
        {"side",
         "area-half",
         QT_TRANSLATE_NOOP("Tools", "Grab &One Side"),
         QT_TRANSLATE_NOOP("Tools",
                           "Take hold of all that lies beyond a plane through a point of the surface"),
         "Shift+P",
         Mode::Pins,
         {},
         nullptr,
         area<Area::Half>},
        {"outlineLasso",
         "area-lasso",
         QT_TRANSLATE_NOOP("Tools", "Outline by &Lasso"),
         QT_TRANSLATE_NOOP("Tools", "Draw around what shall bend, or shall not"),
         "L",
         Mode::Mesh,
         {},
         outline<Draw::Lasso>,
         nullptr,
         outlineOptions},
        {"outlinePolygon",
         "outline-polygon",
         QT_TRANSLATE_NOOP("Tools", "Outline by &Polygon"),
         QT_TRANSLATE_NOOP("Tools", "Set the corners of what shall bend, or shall not"),
         "Shift+L",
         Mode::Mesh,
         {},
         outline<Draw::Polygon>,
         nullptr,
         outlineOptions},
        {"outlineBrush",
         "outline-brush",
         QT_TRANSLATE_NOOP("Tools", "Outline by &Brush"),
         QT_TRANSLATE_NOOP("Tools", "Brush over what shall bend, or shall not"),
         "B",
         Mode::Mesh,
         {},
         outline<Draw::Brush>,
         nullptr,
         outlineBrushOptions},
        {"wand",
         "outline-wand",
         QT_TRANSLATE_NOOP("Tools", "Outline by &Colour"),
         QT_TRANSLATE_NOOP("Tools", "Click on a colour that shall bend, or shall not"),
         "W",
         Mode::Mesh,
         {},
         outline<Draw::Wand>,
         nullptr,
         wandOptions},
        {"cutStroke",
         "outline-cut",
         QT_TRANSLATE_NOOP("Tools", "Cut &Apart"),
         QT_TRANSLATE_NOOP("Tools", "Draw a line along which the shape is parted"),
         "X",
         Mode::Mesh,
         {},
         outline<Draw::Cut>,
         nullptr},
        {"sizes",
         "sizes",
         QT_TRANSLATE_NOOP("Tools", "&Detail Brush"),
         QT_TRANSLATE_NOOP("Tools", "Brush where the mesh is to be finer or coarser"),
         "Shift+A",
         Mode::Mesh,
         {},
         sizeBrush<2>,
         sizeBrush<3>,
         sizeOptions,
         sizes},
        {"paint", "brush", QT_TRANSLATE_NOOP("Tools", "&Paint"),
         QT_TRANSLATE_NOOP("Tools", "Paint what is kept, or how stiff it is"), "B; A", Mode::Paint,
         Mode::Paint, paint<2>, paint<3>, paintOptions, painted},
        {"comb",
         "comb",
         QT_TRANSLATE_NOOP("Tools", "&Comb"),
         QT_TRANSLATE_NOOP("Tools", "Comb the direction along which it is stiff"),
         "N",
         Mode::Paint,
         {},
         paint<2>,
         paint<3>,
         paintOptions,
         painted},
        {"gradient",
         "gradient",
         QT_TRANSLATE_NOOP("Tools", "&Gradient"),
         QT_TRANSLATE_NOOP("Tools", "Drag: what is there changes evenly into what is chosen"),
         "G",
         Mode::Paint,
         {},
         gradient<2>,
         gradient<3>,
         targetOptions,
         painted},
        {"fill",
         "fill",
         QT_TRANSLATE_NOOP("Tools", "&Fill"),
         QT_TRANSLATE_NOOP("Tools", "Fill with what is chosen all that hangs together"),
         "Shift+G",
         Mode::Paint,
         {},
         fill<2>,
         fill<3>,
         targetOptions,
         painted},
        {"eyedropper",
         "pick",
         QT_TRANSLATE_NOOP("Tools", "E&yedropper"),
         QT_TRANSLATE_NOOP("Tools", "Take up what is painted under the pointer"),
         "I",
         Mode::Paint,
         {},
         eyedropper<2>,
         eyedropper<3>,
         nullptr,
         painted},
        {"eraser",
         "eraser",
         QT_TRANSLATE_NOOP("Tools", "E&raser"),
         QT_TRANSLATE_NOOP("Tools", "Take paint off: what is brushed is as everywhere again"),
         "E",
         Mode::Paint,
         {},
         eraser<2>,
         eraser<3>,
         tipOptions,
         painted},
        {"depth",
         "depth",
         QT_TRANSLATE_NOOP("Tools", "Depth Brus&h"),
         QT_TRANSLATE_NOOP("Tools", "Brush over what lies in front where the shape covers itself"),
         "O",
         Mode::Paint,
         {},
         depthBrush,
         nullptr,
         depthOptions},
        {"measure",
         "measure",
         QT_TRANSLATE_NOOP("Tools", "M&easure"),
         QT_TRANSLATE_NOOP("Tools", "Measure lengths and angles between points of the shape"),
         "E; Shift+E",
         Modes::all().without(Mode::Export),
         {},
         measure<2>,
         measure<3>},
        {"crop",
         "crop",
         QT_TRANSLATE_NOOP("Tools", "&Crop"),
         QT_TRANSLATE_NOOP("Tools", "Draw a rectangle around what exports keep of the picture"),
         "C",
         Mode::Export,
         {},
         crop,
         nullptr},
        {"pan",
         "pan",
         QT_TRANSLATE_NOOP("Tools", "Pa&n"),
         QT_TRANSLATE_NOOP("Tools", "Drag the view to another place; in every step the space bar does so"),
         "Q",
         Mode::Export,
         {},
         pan<2>,
         pan<3>},
    };
    return table;
}

}  // namespace wend
