#include "app/window/properties.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/base/preferences.h"
#include "app/panels/cut_out_panel.h"
#include "app/panels/cut_panel.h"
#include "app/panels/distortion_panel.h"
#include "app/panels/facts_panel.h"
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
#include "app/panels/surface_panel.h"
#include "app/session/shape_session.h"
#include "app/style/theme.h"
#include "app/window/actions/toolbox.h"
#include "app/window/export/export_panel.h"

namespace wend {

namespace {

constexpr int kNarrow = 288, kUsual = 304, kWide = 360;  // of the panels
constexpr int kUsualWindow = 1500, kWideWindow = 3000;   // from that width on
constexpr int kPins = 280;                               // a column of their own, in a wide window
constexpr int kSelection = 264;                          // reserved height of the selection

constexpr Modes kShaping = Mode::Mesh | Mode::Pins | Modes(Mode::Paint) | Modes(Mode::Animate);

constexpr int kNarrowWindow = 1100;  // below it the view needs the room
constexpr int kRailButton = 36, kRailIcon = 20;

}  // namespace

Properties::Properties(ShapeSession& session, Exporter& exporter, const Toolbox& tools,
                       const Actions& actions)
    : m_tools(tools),
      m_material(new MaterialPanel(session.document(), session.motion())),
      m_reach(new ReachRow(session.document())),
      m_mesh(new MeshPanel(session.document(), session.motion())),
      m_cutOut(new CutOutPanel(session.document())),
      m_distortion(new DistortionPanel(session.motion(), session.playback())),
      m_cut(new CutPanel),
      m_measure(new MeasurePanel(session.motion(), session.selection(), session.pins())),
      m_paint(new PaintPanel(session.document(), m_brush)),
      m_layers(new LayerPanel(session.document(), m_brush.layer())),
      m_facts(new FactsPanel(session.document(), session.motion())),
      m_detailRegions(new RegionList(session.document(), session.selection(), session.motion(), m_brush,
                                     RegionsOf::Detail)),
      m_depthRegions(new RegionList(session.document(), session.selection(), session.motion(), m_brush,
                                    RegionsOf::Depth)),
      m_groups(new GroupList(session.document(), session.selection())),
      m_surface(new SurfacePanel),
      m_parts(new PartList(session.document(), session.motion(), session.playback())),
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
    connect(&m_tools, &Toolbox::changed, this, &Properties::arrange);
    m_material->installEventFilter(this);
    arrange();
}

/// Adds the panels from top to bottom.
void Properties::fill(ShapeSession& session, Exporter& exporter, const Actions& actions) {
    const Modes posing = Mode::Pins | Mode::Animate;
    put(m_surface, tr("Surface"), "volume", {.modes = Modes::all(), .flat = false});
    connect(m_surface, &SurfacePanel::faultsShown, this, [this](bool isCaged) {
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
    put(m_detailRegions, tr("Detail"), "sizes", {.modes = Mode::Mesh, .tool = "sizes"});
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
    put(new ExportPanel(session.motion(), exporter, actions), tr("Export"), "export",
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

/// Shows the panels of the tool and step. A new step starts at the top; within a step the panel of a new tool
/// is scrolled into view.
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
    onToggled(this, &on, [this](bool shown) {
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

PropertiesRail::PropertiesRail(Properties& properties, QAction& shown, QWidget* parent)
    : QWidget(parent),
      m_properties(properties),
      m_shown(shown),
      m_column(new QVBoxLayout(this)),
      m_wanted(preferences::propertiesShown.value()) {
    setObjectName(QStringLiteral("propertiesRail"));
    setAttribute(Qt::WA_StyledBackground);
    m_column->setContentsMargins(5, 8, 3, 8);  // its line at the left
    m_column->setSpacing(4);
    m_column->addStretch(1);
    m_properties.setParent(parent);
    m_properties.hide();
    onTriggered(this, &m_shown, &PropertiesRail::take);
    connect(&m_properties, &Properties::sectionsChanged, this, &PropertiesRail::showSections);
    showSections();
}

QToolButton* PropertiesRail::buttonOf(QWidget& section) {
    QToolButton*& button = m_buttons[&section];
    if (button) return button;
    button = new QToolButton(this);
    button->setCheckable(true);
    button->setFixedSize(kRailButton, kRailButton);
    button->setIconSize({kRailIcon, kRailIcon});
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, [this, &section] { toggle(section); });
    return button;
}

/// Shows a button for each section of the step, in their order.
void PropertiesRail::showSections() {
    for (const auto& [section, button] : m_buttons) button->hide();
    int place = 0;
    for (const Properties::Section& one : m_properties.sections()) {
        QToolButton* button = buttonOf(*one.place);
        button->setIcon(wendIcon(QString::fromLatin1(one.icon), palette()));
        describe(button, one.name, tr("Opens this part of the properties over the view; Esc closes it."));
        m_column->insertWidget(place++, button);
        button->setVisible(isCollapsed());
    }
}

void PropertiesRail::fitTo(int windowWidth) {
    m_narrow = windowWidth < kNarrowWindow;
    m_properties.fitTo(windowWidth);
    arrange();
}

/// Opens the panels over the view in a narrow window, for now; otherwise the choice is stored.
void PropertiesRail::take(bool shown) {
    if (m_narrow) {
        const auto sections = m_properties.sections();
        shown && !sections.empty() ? open(*sections.front().place) : close();
        return arrange();
    }
    m_wanted = shown;
    preferences::propertiesShown.set(shown);
    close();
    arrange();
}

void PropertiesRail::toggle(QWidget& section) {
    m_open&& m_section == &section ? close() : open(section);
    arrange();
}

void PropertiesRail::open(QWidget& section) {
    if (!isCollapsed()) return;
    m_section = &section;
    if (!std::exchange(m_open, true)) qApp->installEventFilter(this);
    arrange();
    m_properties.raise();
    m_properties.showSection(section);
    m_properties.setFocus(Qt::PopupFocusReason);  // so that Tab moves to its first field
}

void PropertiesRail::openAtSurface() {
    for (const Properties::Section& one : m_properties.sections())
        if (one.place->isAncestorOf(&m_properties.surface())) open(*one.place);
}

void PropertiesRail::close() {
    if (!std::exchange(m_open, false)) return;
    const QWidget* focus = QApplication::focusWidget();
    const bool had = focus && isBeside(*focus);
    m_section = nullptr;
    if (!m_swallows) qApp->removeEventFilter(this);
    arrange();
    if (had) emit done();
}

void PropertiesRail::arrange() {
    if (!isCollapsed() && m_open) close();
    setFixedWidth(isCollapsed() ? kWidth : m_properties.width());
    for (const Properties::Section& one : m_properties.sections()) {
        QToolButton* button = buttonOf(*one.place);
        button->setVisible(isCollapsed());
        button->setChecked(m_open && m_section == one.place);
    }
    place();
    const bool seen = isVisibleTo(parentWidget()) && (m_open || !isCollapsed());
    m_properties.setVisible(seen);
    m_shown.setChecked(m_open || !isCollapsed());
}

/// Places the panels over the rail, or left of it.
void PropertiesRail::place() {
    const int left = isCollapsed() ? x() - m_properties.width() : x();
    m_properties.setGeometry(left, y(), m_properties.width(), height());
}

bool PropertiesRail::isBeside(const QWidget& widget) const {
    return &widget == &m_properties || m_properties.isAncestorOf(&widget) || &widget == this ||
           isAncestorOf(&widget);
}

/// Menus and dialogs that were opened from it are windows of their own.
bool PropertiesRail::closesBy(const QWidget& widget, const QEvent& press) {
    if (widget.window() != window() || isBeside(widget)) return false;
    m_swallows = press.type() == QEvent::MouseButtonPress && parentWidget()->isAncestorOf(&widget);
    close();
    return m_swallows;
}

/// Closes the panels after a click outside. On the view the click does nothing else; on a bar it works as
/// usual.
bool PropertiesRail::eventFilter(QObject* watched, QEvent* event) {
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (!widget) return false;
    if (m_swallows) {
        if (event->type() == QEvent::MouseButtonRelease) {
            m_swallows = false;
            qApp->removeEventFilter(this);
            return true;
        }
        return event->type() == QEvent::MouseMove;
    }
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick)
        return closesBy(*widget, *event);
    if (event->type() != QEvent::KeyPress || QApplication::activePopupWidget() ||
        QApplication::activeModalWidget())
        return false;
    if (static_cast<const QKeyEvent*>(event)->key() != Qt::Key_Escape) return false;
    close();
    return true;
}

void PropertiesRail::resizeEvent(QResizeEvent*) {
    place();
}

void PropertiesRail::moveEvent(QMoveEvent*) {
    place();
}

void PropertiesRail::showEvent(QShowEvent*) {
    arrange();
}

void PropertiesRail::hideEvent(QHideEvent*) {
    if (isHidden()) close();
    arrange();
}

void PropertiesRail::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) showSections();
    QWidget::changeEvent(event);
}

}  // namespace wend
