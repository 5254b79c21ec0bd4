#include "app/window/actions/picture_actions.h"

#include <QActionGroup>
#include <QSpinBox>

namespace wend {

PictureActions::PictureActions(QObject* parent) : ActionMaker(parent) {
    adds = addToggle("adds", {tr("&Add"), tr("What you draw will bend, too; Ctrl takes it away instead")}, {},
                     "add");
    takesAway =
        addToggle("takesAway", {tr("&Take Away"), tr("What you draw will not bend; Ctrl adds it instead")},
                  {}, "take-away");
    makesPart =
        addToggle("makesPart",
                  {tr("Make a &Part"),
                   tr("What you draw becomes a part that bends by itself; what is behind it is filled")},
                  {}, "make-part");
    auto* group = new QActionGroup(this);
    const auto addUse = [&](QAction* action, OutlineUse use) {
        group->addAction(action);
        connect(action, &QAction::toggled, this, [this, use](bool on) {
            OutlineSettings next = m_pen.now();
            next.use = use;
            if (on) m_pen.set(next);
        });
    };
    addUse(adds, OutlineUse::Add);
    addUse(takesAway, OutlineUse::TakeAway);
    addUse(makesPart, OutlineUse::MakePart);
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
    connect(&size->box(), &QSpinBox::valueChanged, this,
            [set](int px) { set([px](auto& s) { s.radius = px / 2.0; }); });
    connect(&tolerance->box(), &QSpinBox::valueChanged, this,
            [set](int percent) { set([percent](auto& s) { s.tolerance = percent / 100.0; }); });
    connect(&m_pen, &OutlinePen::changed, this, &PictureActions::showPen);
    showPen();
}

void PictureActions::showPen() {
    const OutlineSettings& now = m_pen.now();
    QAction* const uses[] = {adds, takesAway, makesPart};
    uses[static_cast<int>(now.use)]->setChecked(true);
    size->put(2 * now.radius);
    tolerance->put(100 * now.tolerance);
}

}  // namespace wend
