#include "app/view/brush_actions.h"

#include <algorithm>
#include <array>

#include "app/panels/energy_scale.h"
#include "app/view/toolbox.h"

namespace wend {

BrushActions::BrushActions(Brush& brush, Toolbox& tools, QObject* parent)
    : ActionMaker(parent), m_brush(brush), m_tools(tools), m_menu(new QMenu) {
    m_menu->setTitle(tr("&Brush"));
    for (int stop = 0; stop < EnergyScale::kStops; ++stop) {
        QAction* action = add({}, QKeySequence(QStringLiteral("Shift+%1").arg(stop + 1)));
        m_menu->addAction(action);
        connect(action, &QAction::triggered, this, [this, stop] { choose(stop); });
    }
    connect(&m_tools, &Toolbox::changed, this, &BrushActions::refresh);
    refresh();
}

/// The first stop has another name for solids.
void BrushActions::refresh() {
    const bool paints = m_tools.dimension() > 0 && m_tools.mode() == Mode::Paint;
    const EnergyScale scale(m_tools.dimension() == 3 ? 3 : 2);
    for (int stop = 0; stop < EnergyScale::kStops; ++stop) {
        QAction* action = own()[stop];
        const EnergyStop& kept = scale.stops()[stop];
        reword(action, {tr("Paint %1").arg(kept.name), kept.shortHelp});
        enable(action, paints, tr("Choose the step “Paint” first."));
    }
}

void BrushActions::choose(int stop) {
    BrushSettings next = m_brush.now();
    next.target = BrushTarget::Keep;
    next.phi = phiAtStop(stop, m_tools.dimension());
    m_brush.set(next);
    const auto isChosen = [this](const char* tool) { return m_tools.isChosen(tool); };
    if (!std::ranges::any_of(std::array{"paint", "gradient", "fill"}, isChosen))
        m_tools.action(QStringLiteral("paint"))->trigger();
}

}  // namespace wend
