#include "app/window/actions/curve_actions.h"

#include <QActionGroup>

#include "app/session/pins/pin_shapes.h"

namespace wend {

CurveActions::CurveActions(ShapeSession& session, std::function<CurveEditor*()> current, QObject* parent)
    : ActionMaker(parent), m_session(session), m_current(std::move(current)), m_menu(new QMenu) {
    makeActions();
    m_menu->setTitle(tr("&Curve"));
    m_menu->addAction(make);
    m_menu->addSeparator();
    m_menu->addActions({insert, remove});
    m_menu->addSeparator();
    m_menu->addActions({free, aligned, automatic});
    connect(m_menu.get(), &QMenu::aboutToShow, this, &CurveActions::refresh);
    refresh();
}

void CurveActions::makeActions() {
    const auto onCurve = [this](auto what) {
        return [this, what] {
            if (CurveEditor* curve = m_current()) what(*curve);
            refresh();
        };
    };
    const auto setKind = [onCurve](JointKind kind) {
        return onCurve([kind](CurveEditor& curve) { curve.setKind(kind); });
    };
    make = add("make", {tr("Edit &Path"), tr("Turn the last path of the selected pin into a Bézier curve")},
               QKeySequence(tr("Shift+C")), [this] { makeCurve(m_session); });
    insert = add("insert",
                 {tr("&Insert Point"),
                  tr("Split the curve at the pointer, or after the chosen point; its shape stays")},
                 QKeySequence(tr("I")), onCurve([](CurveEditor& curve) { curve.insertPoint(); }));
    remove = add("remove", {tr("&Delete Point"), tr("Remove the chosen point from the curve")},
                 QKeySequence(tr("Ctrl+Del")), onCurve([](CurveEditor& curve) { curve.removePoint(); }));
    free = addToggle("free", {tr("&Free"), tr("Let the two directions at the point be independent")},
                     QKeySequence(tr("Alt+1")), setKind(JointKind::Free));
    aligned = addToggle("aligned", {tr("&Aligned"), tr("Keep both directions at the point on one line")},
                        QKeySequence(tr("Alt+2")), setKind(JointKind::Aligned));
    automatic = addToggle(
        "automatic",
        {tr("A&utomatic"), tr("Lead the curve smoothly through the point, guided by its neighbours")},
        QKeySequence(tr("Alt+3")), setKind(JointKind::Automatic));
    oneOf({free, aligned, automatic})->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
}

void CurveActions::refresh() {
    const CurveEditor* curve = m_current();
    const bool has = curve && curve->hasCurve();
    const auto kind = has ? curve->chosenKind() : std::nullopt;
    enable(make, canMakeCurve(m_session), tr("Select one pin that was dragged along a path."));
    enable(insert, has, tr("Select one pin that follows a curve."));
    enable(remove, has && curve->canRemove(), tr("Click a point of the curve first; two must remain."));
    for (QAction* action : {free, aligned, automatic})
        enable(action, kind.has_value(), tr("Click an inner point of a Bézier curve first."));
    free->setChecked(kind == JointKind::Free);
    aligned->setChecked(kind == JointKind::Aligned);
    automatic->setChecked(kind == JointKind::Automatic);
}

void CurveActions::popUp(const QPoint& global) {
    refresh();
    m_menu->popup(global);
}

}  // namespace wend
