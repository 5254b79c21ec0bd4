#include "app/window/actions/picture_actions.h"

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
    using enum OutlineUse;
    choose<OutlineUse>({{adds, Add}, {takesAway, TakeAway}, {makesPart, MakePart}},
                       [this](OutlineUse use) { m_pen.change(&OutlineSettings::use, use); });
    size = new NumberAction(
        tr("Size"), tr("Diameter of the brush on the screen; also [ and ]"), tr(" px"),
        {static_cast<int>(2 * OutlinePen::kSmallest), static_cast<int>(2 * OutlinePen::kLargest)}, this,
        [this](int px) { m_pen.change(&OutlineSettings::radius, px / 2.0); });
    tolerance = new NumberAction(
        tr("Tolerance"), tr("How much colours may differ; this also changes the last click. Also [ and ]"),
        tr(" %"), {1, 100}, this,
        [this](int percent) { m_pen.change(&OutlineSettings::tolerance, percent / 100.0); });
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
