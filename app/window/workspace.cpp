#include "app/window/workspace.h"

#include "app/base/connect_each.h"
#include "app/views/canvas/canvas.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/actions/look_choices.h"
#include "app/window/actions/picture_actions.h"
#include "app/window/actions/pin_actions.h"
#include "app/window/actions/toolbox.h"
#include "app/window/properties.h"
#include "app/window/solid_workshop.h"

namespace wend {

void followLooks(Viewport& view, const Actions& a, const DistortionPanel& map) {
    for (const auto& [action, look] : {std::pair{a.showMesh, &Looks::mesh},
                                       {a.showMap, &Looks::map},
                                       {a.showMarks, &Looks::marks},
                                       {a.showArrows, &Looks::arrows},
                                       {a.onionSkin, &Looks::onionSkin}})
        followLook(view, action, look);
    const auto paper = [&view](const QColor& colour) { view.set(&Looks::backdrop, colour); };
    paper(a.backdrop->colour());
    QObject::connect(a.backdrop, &BackdropChoice::changed, &view, paper);
    const auto colour = [&view, &map] {
        view.set(&Looks::colours, {map.measure(), map.range(), map.opacity(), map.isSmooth()});
    };
    colour();
    connectEach(&view, colour, &map, &DistortionPanel::opacityChanged, &map, &DistortionPanel::mapChanged,
                &map, &DistortionPanel::smoothChanged);
    view.setRangeKeeper(map.keepRange());
}

void followLook(Viewport& view, const QAction* action, bool Looks::*look) {
    view.set(look, action->isChecked());
    onToggled(&view, action, [&view, look](bool on) { view.set(look, on); });
}

PaintMap::PaintMap(DistortionPanel& panel, QAction& showMap) : m_panel(panel), m_showMap(showMap) {
    QObject::connect(&panel, &DistortionPanel::mapChosen, &m_listener, [this] { m_isChosen = true; });
}

void PaintMap::show(Measure wanted) {
    if (m_before && wanted == m_painted) return;
    if (!m_before) m_before = Before{m_panel.measure(), m_showMap.isChecked()};
    m_isChosen = false;
    m_painted = wanted;
    m_panel.setMeasure(wanted);
    m_showMap.setChecked(true);
}

/// Restores the map, unless the user has chosen another one; ignores a measure that a newly opened file
/// lacks.
void PaintMap::end() {
    if (!m_before) return;
    const Before before = *std::exchange(m_before, std::nullopt);
    if (m_isChosen) return;
    m_panel.setMeasure(before.measure);
    if (m_showMap.isChecked()) m_showMap.setChecked(before.shown);
}

Workspace::Workspace(const Parts& parts)
    : m_parts(parts),
      m_map(parts.properties.distortion(), *parts.actions.showMap),
      m_bench{&parts.picture,
              nullptr,
              &parts.properties.brush(),
              &parts.pins.choice(),
              &parts.outline.pen(),
              &parts.crop,
              [select = parts.actions.selectTool] { select->trigger(); }} {
    connect(&m_parts.tools, &Toolbox::changed, this, &Workspace::show);
    // Choosing a marquee shape activates the select tool, unless the pin tool is active.
    for (const QAction* action : {parts.pins.selectRectangle, parts.pins.selectLasso, parts.pins.selectBrush})
        onTriggered(this, action, [this] {
            if (!m_parts.tools.isChosen("pin")) m_parts.actions.selectTool->trigger();
        });
    onToggled(m_bench.pins, parts.solids.actions().through,
              [pins = m_bench.pins](bool on) { pins->change(&PinSettings::through, on); });
    connect(m_bench.brush, &Brush::changed, this, &Workspace::takeBrush);
    show();
}

Workspace::~Workspace() {
    m_parts.picture.viewport().setTool(nullptr);
    if (SolidCanvas* solid = m_parts.solids.canvas()) solid->viewport().setTool(nullptr);
}

Tool* Workspace::toolOf(const ToolKind& kind) {
    const int dimension = m_parts.tools.dimension();
    auto& tool = m_tools[{&kind, dimension}];
    if (!tool) tool = kind.make.of(dimension)(m_bench);
    return tool.get();
}

void Workspace::show() {
    const ToolKind* kind = m_parts.tools.current();
    SolidCanvas* solid = m_parts.solids.canvas();
    m_bench.solid = solid;
    if (solid) solid->cutTool().setFirst(m_parts.tools.mode() == Mode::Mesh);
    m_parts.solids.takeUpTool();
    takeTool();
    if (Viewport* view = viewport(); view && kind) view->setTool(toolOf(*kind));
    if (solid) solid->viewport().set(&Looks::values, m_parts.tools.isChosen("measure"));
    showMap();
}

/// Sets the brush's target, which is the direction for the comb.
void Workspace::takeTool() {
    BrushSettings brush = m_bench.brush->now();
    if (m_parts.tools.isChosen("comb")) brush.target = BrushTarget::Direction;
    if (m_parts.tools.isChosen("paint")) brush.target = m_painted;
    m_bench.brush->set(brush);
}

void Workspace::takeBrush() {
    const BrushTarget target = m_bench.brush->now().target;
    const bool combs = target == BrushTarget::Direction;
    if (!combs) m_painted = target;
    if (m_parts.tools.isChosen(combs ? "paint" : "comb"))
        m_parts.tools.action(combs ? QStringLiteral("comb") : QStringLiteral("paint"))->trigger();
    if (Viewport* view = viewport()) view->lookAgain();
    showMap();
}

void Workspace::showMap() {
    const ToolKind* kind = m_parts.tools.current();
    const auto map = kind && kind->map ? kind->map(m_bench, m_parts.tools.dimension()) : std::nullopt;
    map ? m_map.show(*map) : m_map.end();
}

/// Returns the viewport of the open document; null for solids without OpenGL.
Viewport* Workspace::viewport() const {
    if (m_parts.tools.dimension() != 3) return &m_parts.picture.viewport();
    SolidCanvas* solid = m_parts.solids.canvas();
    return solid ? &solid->viewport() : nullptr;
}

CurveEditor* Workspace::curve() const {
    const Viewport* view = viewport();
    return view && view->tool() ? view->tool()->curve() : nullptr;
}

}  // namespace wend
