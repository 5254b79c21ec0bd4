#include "app/window/actions/pin_actions.h"

#include <QActionGroup>
#include <QApplication>
#include <QColorDialog>
#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <algorithm>

#include "app/project/design.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/pin_edits.h"
#include "app/session/pins/mirroring.h"
#include "app/session/pins/pin_shapes.h"
#include "app/session/pins/pin_traits.h"
#include "app/session/shape_session.h"
#include "app/style/marks.h"
#include "app/tools/pins/curve_editor.h"
#include "app/window/actions/number_action.h"

namespace wend {

namespace {

QIcon patch(const QColor& colour) {
    QPixmap pixmap(14, 14);
    pixmap.fill(colour);
    return pixmap;
}

}  // namespace

PinActions::PinActions(ShapeSession& session, QObject* parent)
    : ActionMaker(parent),
      m_session(session),
      m_document(session.document()),
      m_shown(session.pins()),
      m_menu(new QMenu),
      m_colours(new QMenu) {
    makeGrips();
    makeOutlines();
    makeActions();
    makeColours();
    m_menu->setTitle(tr("&Pins"));
    fill(*m_menu);
    m_menu->insertAction(group, showAll);
    m_menu->insertSeparator(group);
    m_menu->addSeparator();
    m_menu->addMenu(tr("Select &Pins"))->addActions({selectRectangle, selectLasso, selectBrush});
    // Another file starts with the usual meaning of a drag.
    connect(&m_document, &Document::opened, this, [this] { move->setChecked(true); });
    refresh();
}

void PinActions::makeGrips() {
    move = addToggle("move", {tr("Mo&ve"), tr("Drag pins to move them; in a solid, also by the arrows")},
                     QKeySequence(tr("G")), "move");
    turn =
        addToggle("turn", {tr("&Rotate"), tr("Drag to rotate the selected pins; in a solid, by the rings")},
                  QKeySequence(tr("R")), "rotate");
    grow = addToggle("grow", {tr("Sc&ale"), tr("Drag to scale the selected pins; in a solid, by the ring")},
                     QKeySequence(tr("S")), "scale");
    using enum Grip::Kind;
    choose<Grip::Kind>({{move, Move}, {turn, Turn}, {grow, Grow}},
                       [this](Grip::Kind grip) { m_choice.change(&PinSettings::grip, grip); });
    move->setChecked(true);
}

void PinActions::makeOutlines() {
    const QString outline = tr("What the pin tool and the select tool draw around pins to select them");
    selectRectangle =
        addToggle("selectRectangle", {tr("By &Rectangle"), outline}, QKeySequence(tr("Shift+R")));
    selectLasso = addToggle("selectLasso", {tr("By &Lasso"), outline}, QKeySequence(tr("Shift+O")));
    selectBrush = addToggle("selectBrush", {tr("By &Brush"), outline}, QKeySequence(tr("Shift+U")));
    using enum DrawnOutline::Kind;
    choose<DrawnOutline::Kind>(
        {{selectRectangle, Rectangle}, {selectLasso, Lasso}, {selectBrush, Brush}},
        [this](DrawnOutline::Kind kind) { m_choice.change(&PinSettings::selectBy, kind); });
    selectRectangle->setChecked(true);
    snap = addToggle("snap",
                     {tr("S&nap"), tr("New pins sit on corners of the mesh instead of where you click")}, {});
    snap->setChecked(m_choice.now().snaps);
    onToggled(this, snap, [this](bool on) { m_choice.change(&PinSettings::snaps, on); });
    brushSize = new NumberAction(
        tr("Size"), tr("Diameter of the brush on the screen. Also by the keys [ and ]."), tr(" px"),
        {static_cast<int>(2 * PinSettings::kSmallest), static_cast<int>(2 * PinSettings::kLargest)}, this,
        [this](int across) { m_choice.change(&PinSettings::radius, across / 2.0); });
    const auto put = [this] { brushSize->put(2 * m_choice.now().radius); };
    put();
    connect(&m_choice, &PinChoice::changed, this, put);
}

void PinActions::makeActions() {
    lock = addToggle(
        "lock", {tr("&Lock"), tr("The selected pins are neither moved nor removed until unlocked")},
        QKeySequence(tr("Ctrl+L")), [this](bool on) { setLocked(m_document, m_shown, selected(), on); });
    hide =
        addToggle("hide", {tr("&Hide"), tr("The selected pins still hold, but are neither drawn nor picked")},
                  QKeySequence(tr("Ctrl+Shift+H")),
                  [this](bool on) { setHidden(m_document, m_shown, selected(), on); });
    showAll =
        add("showAll", {tr("&Show All"), tr("Show all hidden pins again")}, QKeySequence(tr("Alt+Shift+H")),
            [this] { setHidden(m_document, m_shown, hidden(), false); });
    group = add("group", {tr("&Group…"), tr("Put the selected pins under a heading of the list")},
                QKeySequence(tr("Ctrl+G")), [this] { askGroup(); });
    ungroup =
        add("ungroup", {tr("&Ungroup"), tr("Take the selected pins out of their groups")},
            QKeySequence(tr("Ctrl+Shift+G")), [this] { setGroup(m_document, m_shown, selected(), {}); });
    link = addToggle(
        "link", {tr("Lin&k"), tr("The selected pins move together, whichever of them is dragged")},
        QKeySequence(tr("Ctrl+K")), [this](bool on) { setLinked(m_document, m_shown, selected(), on); });
    mirror = add("mirror",
                 {tr("&Mirror"), tr("Set pins at the mirror images of the selected ones, across the middle "
                                    "of the shape, with mirrored motions")},
                 QKeySequence(tr("Ctrl+M")), [this] { mirrorPins(m_session); });
    mirrorMotion =
        add("mirrorMotion", {tr("Mirror M&otion"), tr("The selected pins move to the other side instead")},
            QKeySequence(tr("Ctrl+Shift+M")), [this] { wend::mirrorMotion(m_session); });
    holdThroughout = add(
        "holdThroughout",
        {tr("Pin for the Whole &Animation"),
         tr("The selected pins hold from the start of the animation to its end, not only from "
            "the time at which they were set")},
        QKeySequence(tr("Ctrl+Shift+F")), [this] { wend::holdThroughout(m_document, m_shown, selected()); });
}

/// Makes the colours in the order of pinColours().
void PinActions::makeColours() {
    const QStringList names = {tr("Blue"),   tr("Orange"), tr("Green"),     tr("Red"),
                               tr("Violet"), tr("Brown"),  tr("Turquoise"), tr("Plum")};
    m_colours->setTitle(tr("&Colour"));
    for (int i = 0; i < names.size(); ++i) {
        const QColor colour = pinColours()[static_cast<std::size_t>(i)];
        m_colours->addAction(patch(colour), names[i], this, [this, colour] {
            setColour(m_document, m_shown, selected(), colour.rgb() & 0xFFFFFF);
        });
    }
    m_colours->addSeparator();
    m_colours->addAction(tr("By &Place in the List"), this,
                         [this] { setColour(m_document, m_shown, selected(), {}); });
    m_colours->addAction(tr("&Other…"), this, &PinActions::askColour);
}

void PinActions::fill(QMenu& menu) const {
    menu.addActions({move, turn, grow});
    menu.addSeparator();
    menu.addActions({lock, hide});
    menu.addMenu(m_colours.get());
    menu.addSeparator();
    menu.addActions({group, ungroup, link});
    menu.addSeparator();
    menu.addActions({mirror, mirrorMotion});
    menu.addSeparator();
    menu.addAction(holdThroughout);
}

std::vector<int> PinActions::selected() const {
    return m_session.selection().handles();
}

QString PinActions::selectedName() const {
    return m_shown.nameOf(selected());
}

std::vector<int> PinActions::hidden() const {
    std::vector<int> hidden;
    for (int h = 0; m_session.motion().frame() && h < m_shown.count(); ++h)
        if (traitsOf(m_document.design(), h).hidden) hidden.push_back(h);
    return hidden;
}

void PinActions::refresh() {
    const std::vector<int> selected = this->selected();
    const bool has = m_session.motion().frame() && !selected.empty();
    const auto count = [&](auto test) { return has ? std::ranges::count_if(selected, test) : 0; };
    const auto all = std::ssize(selected);
    const auto traits = [this](int h) -> const PinTraits& { return traitsOf(m_document.design(), h); };
    for (QAction* grip : {move, turn, grow, selectRectangle, selectLasso, selectBrush})
        enable(grip, m_session.motion().frame() != nullptr, tr("Open a picture first."));
    const QString none = tr("Select a pin first.");
    for (QAction* action : {lock, hide, group, mirror}) enable(action, has, none);
    m_colours->setEnabled(has);
    const auto grouped = count([&](int h) { return !traits(h).group.empty(); });
    const auto linked = count([&](int h) { return isLinked(m_document.design(), h); });
    enable(ungroup, grouped > 0, has ? tr("The selected pin is in no group.") : none);
    enable(link, linked > 0 || (has && all > 1), tr("Select several pins first."));
    enable(mirrorMotion, has && canMirrorMotion(m_session), tr("Select a pin that moves."));
    enable(holdThroughout, has && canHoldLonger(m_document, m_shown, selected),
           has ? tr("The selected pin already holds for the whole animation.") : none);
    enable(showAll, !hidden().empty(), tr("No pin is hidden."));
    lock->setChecked(has && count([&](int h) { return traits(h).locked; }) == all);
    hide->setChecked(has && count([&](int h) { return traits(h).hidden; }) == all);
    link->setChecked(has && linked == all);
}

/// Proposes a name for a new group, so that Enter suffices; existing groups can be chosen.
void PinActions::askGroup() {
    const auto taken = groupNames(m_document.design());
    const std::string& own = traitsOf(m_document.design(), selected().front()).group;
    QStringList names;
    for (const std::string& name : taken) names << QString::fromStdString(name);
    if (own.empty()) names.prepend(QString::fromStdString(freeName(taken, tr("Group").toStdString())));
    QInputDialog dialog(QApplication::activeWindow());
    dialog.setWindowTitle(tr("Group"));
    dialog.setLabelText(tr("Name of the group:"));
    dialog.setComboBoxItems(names);
    dialog.setComboBoxEditable(true);
    dialog.setTextValue(own.empty() ? names.first() : QString::fromStdString(own));
    dialog.findChild<QComboBox*>()->lineEdit()->selectAll();
    const bool given = dialog.exec() == QDialog::Accepted;
    const QString name = dialog.textValue().trimmed();
    if (given && !name.isEmpty()) setGroup(m_document, m_shown, selected(), name);
}

void PinActions::askColour() {
    const int first = selected().front();
    const QColor colour = QColorDialog::getColor(pinColour(first, traitsOf(m_document.design(), first)),
                                                 QApplication::activeWindow(), tr("Colour of the Pin"));
    if (colour.isValid()) setColour(m_document, m_shown, selected(), colour.rgb() & 0xFFFFFF);
}

// --- Curves ---

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
