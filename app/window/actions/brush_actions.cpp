#include "app/window/actions/brush_actions.h"

#include <algorithm>
#include <array>

#include "app/base/connect_each.h"
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
    connectEach(this, &BrushActions::showBrush, &m_brush, &Changing::changed, &m_brush.order(),
                &Changing::changed, &m_brush.edges(), &Changing::changed);
    refresh();
    showBrush();
}

void BrushActions::makeStops() {
    for (int stop = 0; stop < EnergyScale::kStops; ++stop) {
        QAction* action =
            add(QStringLiteral("stop%1").arg(stop + 1), {},
                QKeySequence(QStringLiteral("Shift+%1").arg(stop + 1)), [this, stop] { paint(stop); });
        m_menu->addAction(action);
        m_stops << action;
    }
}

void BrushActions::makeTargets() {
    keep = addToggle("keep", {tr("&Keep"), tr("Paint what the shape keeps when it has to give way")}, {});
    stiffness =
        addToggle("stiffness",
                  {tr("&Stiffness"), tr("Paint how many times stiffer the shape is along a direction")}, {});
    direction = addToggle("direction",
                          {tr("&Direction"), tr("Comb the direction along which the shape is stiff")}, {});
    m_menu->addActions({keep, stiffness, direction});
    using enum BrushTarget;
    choose<BrushTarget>({{keep, Keep}, {stiffness, Stiffness}, {direction, Direction}},
                        [this](BrushTarget target) { m_brush.change(&BrushSettings::target, target); });
}

void BrushActions::makeTip() {
    size = new NumberAction(
        tr("Size"),
        tr("Diameter of the brush on the screen. Also by the keys [ and ], or by "
           "dragging to the right with Alt and the right button."),
        tr(" px"), {static_cast<int>(2 * Brush::kSmallest), static_cast<int>(2 * Brush::kLargest)}, this,
        [this](int across) { m_brush.change(&BrushSettings::radius, across / 2.0); });
    hardness =
        new NumberAction(tr("Hardness"),
                         tr("How much of the brush paints fully; beyond that it fades out. Also by Shift "
                            "with [ and ], or by dragging upwards with Alt and the right button."),
                         tr(" %"), {0, 100, 10}, this,
                         [this](int percent) { m_brush.change(&BrushSettings::hardness, percent / 100.0); });
    amount = new NumberAction(
        tr("Amount"), tr("How far a stroke goes from what is there to what is painted."), tr(" %"),
        {1, 100, 10}, this, [this](int percent) { m_brush.change(&BrushSettings::amount, percent / 100.0); });
    pressure = addToggle(
        "pressure", {tr("&Pressure"), tr("The harder a pen is pressed, the more of the amount is painted")},
        {});
    pressure->setObjectName(QStringLiteral("pressure"));
    onToggled(this, pressure, [this](bool on) { m_brush.change(&BrushSettings::pressure, on); });
}

void BrushActions::makeNumbers() {
    order = new NumberAction(
        tr("Order"), tr("What you brush over lies in front if this is greater than 0, behind if it is less"),
        {}, {-99, 99}, this, [this](int value) { m_brush.order().set(value); });
    edges = new NumberAction(
        tr("Edges"), tr("How long the mesh's edges are where you brush, compared with elsewhere"), tr(" %"),
        {10, 400, 10}, this, [this](int percent) { m_brush.edges().set(percent / 100.0); });
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

/// Updates the names, because the first stop has another one for solids.
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

void BrushActions::paint(int stop) {
    BrushSettings brush = m_brush.now();
    brush.target = BrushTarget::Keep;
    brush.phi = phiAtStop(stop, m_tools.dimension());
    m_brush.set(brush);
    const auto isChosen = [this](const char* tool) { return m_tools.isChosen(tool); };
    if (!std::ranges::any_of(std::array{"paint", "gradient", "fill"}, isChosen))
        m_tools.action(QStringLiteral("paint"))->trigger();
}

}  // namespace wend
