#include "app/view/actions/picture_actions.h"

#include <QActionGroup>
#include <QSpinBox>

namespace wend {

PictureActions::PictureActions(QObject* parent) : ActionMaker(parent) {
    adds = addToggle({tr("&Add"), tr("What you draw will bend, too; Ctrl takes it away instead")}, {}, "add");
    takesAway = addToggle({tr("&Take Away"), tr("What you draw will not bend; Ctrl adds it instead")}, {},
                          "take-away");
    auto* group = new QActionGroup(this);
    group->addAction(adds);
    group->addAction(takesAway);
    size = new NumberAction(tr("Size"), tr("Diameter of the brush on the screen; also [ and ]"), tr(" px"),
                            this);
    size->box().setRange(static_cast<int>(2 * OutlinePen::kSmallest),
                         static_cast<int>(2 * OutlinePen::kLargest));
    tolerance = new NumberAction(
        tr("Tolerance"), tr("How much colours may differ; this also changes the last click. Also [ and ]"),
        tr(" %"), this);
    tolerance->box().setRange(1, 100);
    const auto set = [this](auto change) {
        OutlineSettings next = m_pen.now();
        change(next);
        m_pen.set(next);
    };
    connect(takesAway, &QAction::toggled, this, [set](bool on) { set([on](auto& s) { s.takesAway = on; }); });
    connect(&size->box(), &QSpinBox::valueChanged, this,
            [set](int px) { set([px](auto& s) { s.radius = px / 2.0; }); });
    connect(&tolerance->box(), &QSpinBox::valueChanged, this,
            [set](int percent) { set([percent](auto& s) { s.tolerance = percent / 100.0; }); });
    connect(&m_pen, &OutlinePen::changed, this, &PictureActions::showPen);
    showPen();
}

void PictureActions::showPen() {
    const OutlineSettings& now = m_pen.now();
    (now.takesAway ? takesAway : adds)->setChecked(true);
    size->put(2 * now.radius);
    tolerance->put(100 * now.tolerance);
}

}  // namespace wend
