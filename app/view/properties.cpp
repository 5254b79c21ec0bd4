#include "app/view/properties.h"

#include <QAction>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include "app/panels/balance_panel.h"
#include "app/panels/cut_out_panel.h"
#include "app/panels/cut_panel.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/flow_panel.h"
#include "app/panels/folding_section.h"
#include "app/panels/handle_panel.h"
#include "app/panels/layer_panel.h"
#include "app/panels/material_panel.h"
#include "app/panels/measure_panel.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/paint_panel.h"
#include "app/panels/panel_fields.h"
#include "app/panels/panel_parts.h"
#include "app/panels/pin_list.h"
#include "app/panels/reach_row.h"
#include "app/panels/region_list.h"
#include "app/panels/region_panel.h"
#include "app/panels/size_panel.h"
#include "app/panels/surface_panel.h"
#include "app/view/export_panel.h"
#include "app/view/toolbox.h"

namespace wend {

namespace {

constexpr int kNarrow = 288, kUsual = 304, kWide = 360;  // of the panels
constexpr int kUsualWindow = 1500, kWideWindow = 3000;   // from that width on
constexpr int kSelection = 200;                          // the room for what is selected

constexpr Modes kShaping = Mode::Mesh | Mode::Pins | Modes(Mode::Paint) | Modes(Mode::Animate);

}  // namespace

Properties::Properties(ShapeSession& session, Exporter& exporter, const Toolbox& tools,
                       const Actions& actions)
    : m_tools(tools),
      m_material(new MaterialPanel(session)),
      m_reach(new ReachRow(session.document())),
      m_mesh(new MeshPanel(session)),
      m_cutOut(new CutOutPanel(session)),
      m_distortion(new DistortionPanel(session)),
      m_cut(new CutPanel),
      m_measure(new MeasurePanel(session)),
      m_paint(new PaintPanel(session, m_brush)),
      m_layers(new LayerPanel(session)),
      m_sizes(new SizePanel(session)),
      m_detailRegions(new RegionList(session, RegionsOf::Detail)),
      m_depthRegions(new RegionList(session, RegionsOf::Depth)),
      m_surface(new SurfacePanel),
      m_pins(new PinList(session)),
      m_advanced(new FoldingSection(tr("Advanced"), tr("The same in numbers, for those who want them."),
                                    QStringLiteral("advanced"))),
      m_content(new QWidget),
      m_column(new QVBoxLayout(m_content)),
      m_scroll(new QScrollArea) {
    setObjectName(QStringLiteral("sidePanel"));
    setAttribute(Qt::WA_StyledBackground);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
    fill(session, exporter, actions);
    m_column->addStretch(1);
    m_scroll->setObjectName(QStringLiteral("sideScroll"));
    m_scroll->setWidget(m_content);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFrameShape(QFrame::NoFrame);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(1, 0, 0, 0);  // its line at the left
    column->setSpacing(0);
    column->addWidget(m_material);
    column->addWidget(m_reach);
    column->addWidget(panelLine(this));
    column->addWidget(m_scroll, 1);
    connect(new PanelFields(*this), &PanelFields::done, this, &Properties::done);
    connect(m_pins, &PinList::done, this, &Properties::done);
    connect(&m_tools, &Toolbox::changed, this, &Properties::arrange);
    arrange();
}

/// In their order from the top.
void Properties::fill(ShapeSession& session, Exporter& exporter, const Actions& actions) {
    const Modes posing = Mode::Pins | Mode::Animate;
    put(m_surface, {.modes = Modes::all(), .flat = false});
    put(m_mesh, {.modes = Mode::Mesh});
    put(m_sizes, {.modes = Mode::Mesh, .flat = false, .tool = "sizes"});
    put(m_detailRegions, {.modes = Mode::Mesh, .solid = false, .tool = "sizes"});
    put(m_depthRegions, {.modes = Mode::Paint, .solid = false, .tool = "depth"});
    put(m_paint, {.modes = Mode::Paint, .without = "depth"});
    put(m_layers, {.modes = Mode::Paint});
    put(m_pins, {.modes = Mode::Pins});
    put(selectionArea(session), {.modes = posing});
    put(new FlowPanel(session), {.modes = Mode::Animate});
    put(new ExportPanel(session, exporter, actions), {.modes = Mode::Export, .fills = true});
    put(m_measure, {.modes = Modes::all(), .flat = false, .tool = "measure"});
    put(m_cut, {.modes = Mode::Mesh, .flat = false});
    put(m_distortion, {.modes = kShaping});
    m_advanced->add(m_cutOut);
    m_advanced->add(new BalancePanel(session));
    m_advanced->add(m_distortion->details());
    put(m_advanced, {.modes = kShaping});
}

/// Panels that hide when they have nothing to say are within something that is shown by the step.
void Properties::put(QWidget* panel, const When& when) {
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(panel);
    column->addWidget(panelLine(holder));
    m_column->addWidget(holder, when.fills ? 100 : 0);
    m_places.emplace_back(holder, when);
}

QWidget* Properties::selectionArea(ShapeSession& session) {
    auto* area = new QWidget;
    area->setObjectName(QStringLiteral("selectionArea"));
    area->setMinimumHeight(kSelection);
    auto* column = new QVBoxLayout(area);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new HandlePanel(session));
    column->addWidget(new RegionPanel(session));
    column->addStretch(1);
    return area;
}

bool Properties::isDue(const When& when) const {
    if (m_tools.dimension() == 3 ? !when.solid : !when.flat) return false;
    if (when.tool && !m_tools.isChosen(when.tool)) return false;
    if (when.without && m_tools.isChosen(when.without)) return false;
    return when.modes.has(m_tools.mode()) || (when.on && when.on->isChecked());
}

void Properties::arrange() {
    for (const auto& [holder, when] : m_places) holder->setVisible(isDue(when));
    m_material->setVisible(m_tools.mode() != Mode::Export);  // its room is the preview's
    m_reach->setVisible((Mode::Pins | Mode::Paint).has(m_tools.mode()));
    m_cutOut->setVisible(m_tools.dimension() == 2 && m_tools.mode() == Mode::Mesh);
}

void Properties::showCutWhile(const QAction& on) {
    for (auto& [holder, when] : m_places)
        if (holder->isAncestorOf(m_cut)) when.on = &on;
    connect(&on, &QAction::toggled, this, [this](bool shown) {
        arrange();
        if (shown) QTimer::singleShot(0, this, [this] { m_scroll->ensureWidgetVisible(m_cut); });
    });
}

void Properties::fitTo(int windowWidth) {
    setFixedWidth(windowWidth < kUsualWindow ? kNarrow : windowWidth < kWideWindow ? kUsual : kWide);
}

}  // namespace wend
