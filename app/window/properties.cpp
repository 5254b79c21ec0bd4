#include "app/window/properties.h"

#include <QAction>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/panels/balance_panel.h"
#include "app/panels/cut_out_panel.h"
#include "app/panels/cut_panel.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/facts_panel.h"
#include "app/panels/fields/panel_fields.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/film_panel.h"
#include "app/panels/flow_panel.h"
#include "app/panels/group_list.h"
#include "app/panels/handle_panel.h"
#include "app/panels/layer_panel.h"
#include "app/panels/material_panel.h"
#include "app/panels/measure_panel.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/paint_panel.h"
#include "app/panels/part_list.h"
#include "app/panels/pin_list.h"
#include "app/panels/region_list.h"
#include "app/panels/region_panel.h"
#include "app/panels/size_panel.h"
#include "app/panels/surface_panel.h"
#include "app/window/actions/toolbox.h"
#include "app/window/export/export_panel.h"

namespace wend {

namespace {

constexpr int kNarrow = 288, kUsual = 304, kWide = 360;  // of the panels
constexpr int kUsualWindow = 1500, kWideWindow = 3000;   // from that width on
constexpr int kPins = 280;                               // a column of their own, in a wide window
constexpr int kSelection = 264;                          // reserved height of the selection

constexpr Modes kShaping = Mode::Mesh | Mode::Pins | Modes(Mode::Paint) | Modes(Mode::Animate);

}  // namespace

Properties::Properties(ShapeSession& session, Exporter& exporter, const Toolbox& tools,
                       const Actions& actions)
    : m_tools(tools),
      m_material(new MaterialPanel(session)),
      m_reach(new ReachRow(session.document())),
      m_mesh(new MeshPanel(session)),
      m_cutOut(new CutOutPanel(session.document())),
      m_distortion(new DistortionPanel(session)),
      m_cut(new CutPanel),
      m_measure(new MeasurePanel(session)),
      m_paint(new PaintPanel(session.document(), m_brush)),
      m_layers(new LayerPanel(session, m_brush.layer())),
      m_facts(new FactsPanel(session)),
      m_sizes(new SizePanel(session, m_brush)),
      m_detailRegions(new RegionList(session, RegionsOf::Detail)),
      m_depthRegions(new RegionList(session, RegionsOf::Depth)),
      m_groups(new GroupList(session)),
      m_surface(new SurfacePanel),
      m_parts(new PartList(session)),
      m_pins(new PinList(session)),
      m_advanced(new FoldingSection(tr("Advanced"), tr("The same in numbers, for those who want them."),
                                    QStringLiteral("advanced"))),
      m_content(new QWidget),
      m_beside(new QWidget(this)),
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
    m_beside->setObjectName(QStringLiteral("pinColumn"));
    m_beside->setAttribute(Qt::WA_StyledBackground);
    m_beside->setFixedWidth(kPins);
    m_beside->hide();
    (new QVBoxLayout(m_beside))->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(1, 0, 0, 0);  // its line at the left
    row->setSpacing(0);
    row->addWidget(m_beside);
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    row->addLayout(column, 1);
    column->addWidget(m_material);
    column->addWidget(m_reach);
    column->addWidget(panelLine(this));
    column->addWidget(m_scroll, 1);
    connect(new PanelFields(*this), &PanelFields::done, this, &Properties::done);
    connect(m_pins, &PinList::done, this, &Properties::done);
    connect(&m_tools, &Toolbox::changed, this, &Properties::arrange);
    m_material->installEventFilter(this);
    arrange();
}

/// Adds the panels from top to bottom.
void Properties::fill(ShapeSession& session, Exporter& exporter, const Actions& actions) {
    const Modes posing = Mode::Pins | Mode::Animate;
    put(m_surface, tr("Surface"), "volume", {.modes = Modes::all(), .flat = false});
    connect(m_surface, &SurfacePanel::told, this, [this](bool isCaged) {
        place(*m_surface).when.modes = isCaged ? Modes(Mode::Mesh) : Modes::all();
        arrange();
    });
    put(m_mesh, tr("Mesh"), "mesh", {.modes = Mode::Mesh});
    auto* facts = new FoldingSection(tr("Facts"),
                                     tr("Size, area, volume and edges, the quality of the cells, "
                                        "and gaps that a cage closes."),
                                     QStringLiteral("facts"));
    facts->add(m_facts);
    put(facts, tr("Facts"), "measure", {.modes = Mode::Mesh, .flat = false});
    put(m_sizes, tr("Sizes"), "sizes", {.modes = Mode::Mesh, .flat = false, .tool = "sizes"});
    put(m_detailRegions, tr("Detail"), "sizes", {.modes = Mode::Mesh, .solid = false, .tool = "sizes"});
    put(m_depthRegions, tr("Depth"), "depth", {.modes = Mode::Paint, .solid = false, .tool = "depth"});
    put(m_paint, tr("Paint"), "brush", {.modes = Mode::Paint, .without = "depth"});
    put(m_layers, tr("Layers"), "layers", {.modes = Mode::Paint});
    put(m_parts, tr("Parts"), "layers", {.modes = kShaping, .solid = false});
    connect(m_parts, &PartList::chosenChanged, m_mesh, &MeshPanel::setPart);
    connect(m_mesh, &MeshPanel::partChosen, m_cutOut, &CutOutPanel::setPart);
    put(m_pins, tr("Pins"), "pin", {.modes = Mode::Pins});
    put(m_groups, tr("Groups"), "select", {.modes = Mode::Pins});
    put(selectionArea(session), tr("Selection"), "select", {.modes = posing});
    put(new FlowPanel(session.document(), session.playback()), tr("Flow"), "curve", {.modes = Mode::Animate});
    put(new FilmPanel(session.document()), tr("Film"), "frames", {.modes = Mode::Animate});
    put(new ExportPanel(session, exporter, actions), tr("Export"), "export",
        {.modes = Mode::Export, .fills = true});
    put(m_measure, tr("Measure"), "measure", {.modes = Modes::all(), .flat = false, .tool = "measure"});
    put(m_cut, tr("Cut"), "cut", {.modes = Mode::Mesh, .flat = false});
    put(m_distortion, tr("What changed"), "distortion", {.modes = kShaping});
    m_advanced->add(m_cutOut);
    m_advanced->add(new BalancePanel(session.document()));
    m_advanced->add(m_distortion->details());
    put(m_advanced, tr("Advanced"), "settings", {.modes = kShaping});
}

/// Panels that hide when they have nothing to say are within something that is shown by the step.
void Properties::put(QWidget* panel, const QString& name, const char* icon, const When& when) {
    auto* holder = new QWidget;
    auto* column = bareColumn(holder, 0);
    column->addWidget(panel);
    column->addWidget(panelLine(holder));
    m_column->addWidget(holder, when.fills ? 100 : 0);
    panel->installEventFilter(this);
    m_places.push_back({holder, panel, name, icon, when});
}

Properties::Place& Properties::place(const QWidget& panel) {
    return *std::ranges::find(m_places, &panel, &Place::panel);
}

QWidget* Properties::selectionArea(ShapeSession& session) {
    auto* area = new QWidget;
    area->setObjectName(QStringLiteral("selectionArea"));
    area->setMinimumHeight(kSelection);
    area->installEventFilter(this);
    auto* column = bareColumn(area, 0);
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

/// A new step starts at the top; within a step the panel of a new tool is scrolled into view.
void Properties::arrange() {
    const bool isNewStep = std::exchange(m_mode, m_tools.mode()) != m_tools.mode();
    if (isNewStep) m_scroll->verticalScrollBar()->setValue(0);
    for (const Place& one : m_places) {
        const bool comes = one.holder->isHidden() && isDue(one.when);
        one.holder->setVisible(isDue(one.when));
        if (comes && one.when.tool && !isNewStep)
            QTimer::singleShot(0, one.holder,
                               [this, &part = *one.holder] { m_scroll->ensureWidgetVisible(&part); });
    }
    m_material->setVisible(m_tools.mode() != Mode::Export);  // its room is the preview's
    m_material->setBesideBrush(m_tools.mode() == Mode::Paint);
    m_reach->setVisible((Mode::Pins | Mode::Paint).has(m_tools.mode()));
    m_cutOut->setVisible(m_tools.dimension() == 2 && m_tools.mode() == Mode::Mesh);
    emit sectionsChanged();
}

std::vector<Properties::Section> Properties::sections() const {
    std::vector<Section> all;
    if (!m_material->isHidden()) all.push_back({tr("Keep"), "energy", m_material});
    for (const Place& one : m_places)
        if (!one.holder->isHidden() && !one.panel->isHidden())
            all.push_back({one.name, one.icon, one.holder});
    return all;
}

/// Follows panels that show and hide themselves. The height for the selection stays reserved, so that
/// everything below stays in place.
bool Properties::eventFilter(QObject* watched, QEvent* event) {
    auto& part = static_cast<QWidget&>(*watched);
    if (event->type() == QEvent::LayoutRequest && part.objectName() == QStringLiteral("selectionArea"))
        part.setMinimumHeight(std::max(part.minimumHeight(), part.layout()->sizeHint().height()));
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent)
        emit sectionsChanged();
    return QWidget::eventFilter(watched, event);
}

/// Scrolls a section to the top as far as possible, once the layout is done.
void Properties::showSection(QWidget& section) {
    if (!m_content->isAncestorOf(&section)) return;
    QTimer::singleShot(0, &section, [this, &section] {
        m_scroll->verticalScrollBar()->setValue(section.mapTo(m_content, QPoint()).y());
    });
}

void Properties::showCutWhile(const QAction& on) {
    place(*m_cut).when.on = &on;
    connect(&on, &QAction::toggled, this, [this](bool shown) {
        arrange();
        if (shown) QTimer::singleShot(0, this, [this] { m_scroll->ensureWidgetVisible(m_cut); });
    });
}

void Properties::putPinsBeside(bool beside) {
    if (beside == !m_beside->isHidden()) return;
    const auto pins = std::ranges::find(m_places, m_pins, &Place::panel);
    if (beside) {
        m_beside->layout()->addWidget(pins->holder);
        pins->when.modes = Modes::all();
    } else {
        const auto before = std::prev(pins);
        m_column->insertWidget(m_column->indexOf(before->holder) + 1, pins->holder);
        pins->when.modes = Mode::Pins;
    }
    m_pins->setFills(beside);
    m_beside->setVisible(beside);
    arrange();
}

void Properties::fitTo(int windowWidth) {
    const bool wide = windowWidth >= kWideWindow;
    putPinsBeside(wide);
    setFixedWidth(windowWidth < kUsualWindow ? kNarrow : wide ? kWide + kPins : kUsual);
}

}  // namespace wend
