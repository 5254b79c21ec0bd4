#include "app/window/actions/brush_actions.h"

#include <QActionGroup>
#include <QSpinBox>
#include <algorithm>
#include <array>

#include "app/style/energy_scale.h"
#include "app/window/actions/toolbox.h"

namespace wend {

BrushActions::BrushActions(Brush& brush, Toolbox& tools, QObject* parent)
    : ActionMaker(parent), m_brush(brush), m_tools(tools), m_menu(new QMenu) {
    m_menu->setTitle(tr("&Brush"));
    makeTargets();
    m_menu->addSeparator();
    makeStops();
    makeTip();
    makeNumbers();
    connect(&m_tools, &Toolbox::changed, this, &BrushActions::refresh);
    for (const Changing* value :
         std::initializer_list<Changing*>{&m_brush, &m_brush.order(), &m_brush.edges()})
        connect(value, &Changing::changed, this, &BrushActions::showBrush);
    refresh();
    showBrush();
}

template <class Change>
void BrushActions::change(const Change& change) {
    BrushSettings next = m_brush.now();
    change(next);
    m_brush.set(next);
}

void BrushActions::makeStops() {
    for (int stop = 0; stop < EnergyScale::kStops; ++stop) {
        QAction* action = add(QStringLiteral("stop%1").arg(stop + 1), {},
                              QKeySequence(QStringLiteral("Shift+%1").arg(stop + 1)));
        m_menu->addAction(action);
        m_stops << action;
        connect(action, &QAction::triggered, this, [this, stop] { choose(stop); });
    }
}

void BrushActions::makeTargets() {
    keep = addToggle("keep", {tr("&Keep"), tr("Paint what the shape keeps when it has to give way")}, {});
    stiffness =
        addToggle("stiffness",
                  {tr("&Stiffness"), tr("Paint how many times stiffer the shape is along a direction")}, {});
    direction = addToggle("direction",
                          {tr("&Direction"), tr("Comb the direction along which the shape is stiff")}, {});
    auto* group = new QActionGroup(this);
    for (const auto& [action, target] : {std::pair{keep, BrushTarget::Keep},
                                         {stiffness, BrushTarget::Stiffness},
                                         {direction, BrushTarget::Direction}}) {
        group->addAction(action);
        m_menu->addAction(action);
        connect(action, &QAction::triggered, this,
                [this, target = target] { change([&](BrushSettings& brush) { brush.target = target; }); });
    }
}

void BrushActions::makeTip() {
    size = new NumberAction(tr("Size"),
                            tr("Diameter of the brush on the screen. Also by the keys [ and ], or by "
                               "dragging to the right with Alt and the right button."),
                            tr(" px"), this);
    size->box().setRange(static_cast<int>(2 * Brush::kSmallest), static_cast<int>(2 * Brush::kLargest));
    hardness =
        new NumberAction(tr("Hardness"),
                         tr("How much of the brush paints fully; beyond that it fades out. Also by Shift "
                            "with [ and ], or by dragging upwards with Alt and the right button."),
                         tr(" %"), this);
    hardness->box().setRange(0, 100);
    amount = new NumberAction(
        tr("Amount"), tr("How far a stroke goes from what is there to what is painted."), tr(" %"), this);
    amount->box().setRange(1, 100);
    for (const NumberAction* part : {hardness, amount}) part->box().setSingleStep(10);
    pressure = addToggle(
        "pressure", {tr("&Pressure"), tr("The harder a pen is pressed, the more of the amount is painted")},
        {});
    pressure->setObjectName(QStringLiteral("pressure"));
    connect(&size->box(), &QSpinBox::valueChanged, this,
            [this](int across) { change([&](BrushSettings& brush) { brush.radius = across / 2.0; }); });
    connect(&hardness->box(), &QSpinBox::valueChanged, this,
            [this](int percent) { change([&](BrushSettings& brush) { brush.hardness = percent / 100.0; }); });
    connect(&amount->box(), &QSpinBox::valueChanged, this,
            [this](int percent) { change([&](BrushSettings& brush) { brush.amount = percent / 100.0; }); });
    connect(pressure, &QAction::toggled, this,
            [this](bool on) { change([&](BrushSettings& brush) { brush.pressure = on; }); });
}

void BrushActions::makeNumbers() {
    order = new NumberAction(
        tr("Order"), tr("What you brush over lies in front if this is greater than 0, behind if it is less"),
        {}, this);
    order->box().setRange(-99, 99);
    edges = new NumberAction(tr("Edges"),
                             tr("How long the mesh's edges are where you brush, compared with elsewhere"),
                             tr(" %"), this);
    edges->box().setRange(10, 400);
    edges->box().setSingleStep(10);
    connect(&order->box(), &QSpinBox::valueChanged, this, [this](int value) { m_brush.order().set(value); });
    connect(&edges->box(), &QSpinBox::valueChanged, this,
            [this](int percent) { m_brush.edges().set(percent / 100.0); });
}

void BrushActions::showBrush() {
    const BrushSettings& brush = m_brush.now();
    const std::array targets{keep, stiffness, direction};
    targets[static_cast<std::size_t>(brush.target)]->setChecked(true);
    size->put(2 * brush.radius);
    hardness->put(100 * brush.hardness);
    amount->put(100 * brush.amount);
    order->put(m_brush.order().now());
    edges->put(100 * m_brush.edges().now());
    pressure->setChecked(brush.pressure);
}

/// The first stop has another name for solids.
void BrushActions::refresh() {
    const bool paints = m_tools.dimension() > 0 && m_tools.mode() == Mode::Paint;
    const EnergyScale scale(m_tools.dimension() == 3 ? 3 : 2);
    for (int stop = 0; stop < EnergyScale::kStops; ++stop) {
        QAction* action = m_stops[stop];
        const EnergyStop& kept = scale.stops()[stop];
        reword(action, {tr("Paint %1").arg(kept.name), kept.shortHelp});
        enable(action, paints, tr("Choose the step “Paint” first."));
    }
}

void BrushActions::choose(int stop) {
    change([&](BrushSettings& brush) {
        brush.target = BrushTarget::Keep;
        brush.phi = phiAtStop(stop, m_tools.dimension());
    });
    const auto isChosen = [this](const char* tool) { return m_tools.isChosen(tool); };
    if (!std::ranges::any_of(std::array{"paint", "gradient", "fill"}, isChosen))
        m_tools.action(QStringLiteral("paint"))->trigger();
}

}  // namespace wend
