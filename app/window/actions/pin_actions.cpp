#include "app/window/actions/pin_actions.h"

#include <QActionGroup>
#include <QApplication>
#include <QColorDialog>
#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QSpinBox>
#include <algorithm>

#include "app/project/design.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/pin_edits.h"
#include "app/session/calm_follower.h"
#include "app/session/pins/mirroring.h"
#include "app/session/pins/pin_traits.h"
#include "app/style/marks.h"
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
    : ActionMaker(parent), m_session(session), m_menu(new QMenu), m_colours(new QMenu) {
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
    connectActions();
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
    auto* grips = new QActionGroup(this);
    for (QAction* grip : {move, turn, grow}) grips->addAction(grip);
    move->setChecked(true);
    using enum Grip::Kind;
    choose(&PinSettings::grip, {{move, Move}, {turn, Turn}, {grow, Grow}});
}

void PinActions::makeOutlines() {
    const QString outline = tr("What the pin tool and the select tool draw around pins to select them");
    selectRectangle =
        addToggle("selectRectangle", {tr("By &Rectangle"), outline}, QKeySequence(tr("Shift+R")));
    selectLasso = addToggle("selectLasso", {tr("By &Lasso"), outline}, QKeySequence(tr("Shift+O")));
    selectBrush = addToggle("selectBrush", {tr("By &Brush"), outline}, QKeySequence(tr("Shift+U")));
    auto* outlines = new QActionGroup(this);
    for (QAction* one : {selectRectangle, selectLasso, selectBrush}) outlines->addAction(one);
    selectRectangle->setChecked(true);
    using enum DrawnOutline::Kind;
    choose(&PinSettings::selectBy,
           {{selectRectangle, Rectangle}, {selectLasso, Lasso}, {selectBrush, Brush}});
    snap = addToggle("snap",
                     {tr("S&nap"), tr("New pins sit on corners of the mesh instead of where you click")}, {});
    snap->setChecked(m_choice.now().snaps);
    connect(snap, &QAction::toggled, this, [this](bool on) { m_choice.change(&PinSettings::snaps, on); });
    brushSize = new NumberAction(
        tr("Size"), tr("Diameter of the brush on the screen. Also by the keys [ and ]."), tr(" px"), this);
    brushSize->box().setRange(static_cast<int>(2 * PinSettings::kSmallest),
                              static_cast<int>(2 * PinSettings::kLargest));
    const auto put = [this] { brushSize->put(2 * m_choice.now().radius); };
    put();
    connect(&m_choice, &PinChoice::changed, this, put);
    connect(&brushSize->box(), &QSpinBox::valueChanged, this,
            [this](int across) { m_choice.change(&PinSettings::radius, across / 2.0); });
}

/// Connects a switch of a group with the value that it selects.
template <class Value>
void PinActions::choose(Value PinSettings::*value,
                        std::initializer_list<std::pair<QAction*, Value>> choices) {
    for (const auto& [action, choice] : choices)
        connect(action, &QAction::toggled, this, [this, value, choice = choice](bool on) {
            if (on) m_choice.change(value, choice);
        });
}

void PinActions::makeActions() {
    lock =
        addToggle("lock", {tr("&Lock"), tr("The selected pins are neither moved nor removed until unlocked")},
                  QKeySequence(tr("Ctrl+L")));
    hide =
        addToggle("hide", {tr("&Hide"), tr("The selected pins still hold, but are neither drawn nor picked")},
                  QKeySequence(tr("Ctrl+Shift+H")));
    showAll =
        add("showAll", {tr("&Show All"), tr("Show all hidden pins again")}, QKeySequence(tr("Alt+Shift+H")));
    group = add("group", {tr("&Group…"), tr("Put the selected pins under a heading of the list")},
                QKeySequence(tr("Ctrl+G")));
    ungroup = add("ungroup", {tr("&Ungroup"), tr("Take the selected pins out of their groups")},
                  QKeySequence(tr("Ctrl+Shift+G")));
    link =
        addToggle("link", {tr("Lin&k"), tr("The selected pins move together, whichever of them is dragged")},
                  QKeySequence(tr("Ctrl+K")));
    mirror = add("mirror",
                 {tr("&Mirror"), tr("Set pins at the mirror images of the selected ones, across the middle "
                                    "of the shape, with mirrored motions")},
                 QKeySequence(tr("Ctrl+M")));
    mirrorMotion =
        add("mirrorMotion", {tr("Mirror M&otion"), tr("The selected pins move to the other side instead")},
            QKeySequence(tr("Ctrl+Shift+M")));
    holdThroughout =
        add("holdThroughout",
            {tr("Pin for the Whole &Animation"),
             tr("The selected pins hold from the start of the animation to its end, not only from "
                "the time at which they were set")},
            QKeySequence(tr("Ctrl+Shift+F")));
}

/// Makes the colours in the order of pinColours().
void PinActions::makeColours() {
    const QStringList names = {tr("Blue"),   tr("Orange"), tr("Green"),     tr("Red"),
                               tr("Violet"), tr("Brown"),  tr("Turquoise"), tr("Plum")};
    m_colours->setTitle(tr("&Colour"));
    for (int i = 0; i < names.size(); ++i) {
        const QColor colour = pinColours()[static_cast<std::size_t>(i)];
        connect(m_colours->addAction(patch(colour), names[i]), &QAction::triggered, this, [this, colour] {
            setColour(m_session.document(), m_session.pins(), selected(), colour.rgb() & 0xFFFFFF);
        });
    }
    m_colours->addSeparator();
    connect(m_colours->addAction(tr("By &Place in the List")), &QAction::triggered, this,
            [this] { setColour(m_session.document(), m_session.pins(), selected(), {}); });
    connect(m_colours->addAction(tr("&Other…")), &QAction::triggered, this, &PinActions::askColour);
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

void PinActions::connectActions() {
    connect(lock, &QAction::triggered, this,
            [this](bool on) { setLocked(m_session.document(), m_session.pins(), selected(), on); });
    connect(hide, &QAction::triggered, this,
            [this](bool on) { setHidden(m_session.document(), m_session.pins(), selected(), on); });
    connect(link, &QAction::triggered, this,
            [this](bool on) { setLinked(m_session.document(), m_session.pins(), selected(), on); });
    connect(showAll, &QAction::triggered, this, [this] {
        std::vector<int> hidden;
        for (int h = 0; h < m_session.pins().count(); ++h)
            if (traitsOf(m_session.document().design(), h).hidden) hidden.push_back(h);
        setHidden(m_session.document(), m_session.pins(), hidden, false);
    });
    connect(group, &QAction::triggered, this, &PinActions::askGroup);
    connect(ungroup, &QAction::triggered, this,
            [this] { setGroup(m_session.document(), m_session.pins(), selected(), {}); });
    connect(mirror, &QAction::triggered, this, [this] { mirrorPins(m_session); });
    connect(mirrorMotion, &QAction::triggered, this, [this] { wend::mirrorMotion(m_session); });
    connect(holdThroughout, &QAction::triggered, this,
            [this] { wend::holdThroughout(m_session.document(), m_session.pins(), selected()); });
    new CalmFollower(
        m_session.motion(), this, [this] { refresh(); }, &m_session.gestures(), &ShapeGesture::pinsChanged,
        &m_session.motion(), &ShapeMotion::frameChanged);
    // Another file starts with the usual meaning of a drag.
    connect(&m_session.document(), &Document::opened, this, [this] { move->setChecked(true); });
}

void PinActions::refresh() {
    const std::vector<int> selected = this->selected();
    const bool has = m_session.motion().frame() && !selected.empty();
    const auto count = [&](auto test) { return has ? std::ranges::count_if(selected, test) : 0; };
    const auto all = std::ssize(selected);
    const auto traits = [this](int h) -> const PinTraits& {
        return traitsOf(m_session.document().design(), h);
    };
    for (QAction* grip : {move, turn, grow, selectRectangle, selectLasso, selectBrush})
        enable(grip, m_session.motion().frame() != nullptr, tr("Open a picture first."));
    const QString none = tr("Select a pin first.");
    for (QAction* action : {lock, hide, group, mirror}) enable(action, has, none);
    m_colours->setEnabled(has);
    const auto grouped = count([&](int h) { return !traits(h).group.empty(); });
    const auto linked = count([&](int h) { return isLinked(m_session.document().design(), h); });
    enable(ungroup, grouped > 0, has ? tr("The selected pin is in no group.") : none);
    enable(link, linked > 0 || (has && all > 1), tr("Select several pins first."));
    enable(mirrorMotion, has && canMirrorMotion(m_session), tr("Select a pin that moves."));
    enable(holdThroughout, has && canHoldLonger(m_session.document(), m_session.pins(), selected),
           has ? tr("The selected pin already holds for the whole animation.") : none);
    bool anyHidden = false;
    for (int h = 0; m_session.motion().frame() && h < m_session.pins().count(); ++h)
        anyHidden = anyHidden || traits(h).hidden;
    enable(showAll, anyHidden, tr("No pin is hidden."));
    lock->setChecked(has && count([&](int h) { return traits(h).locked; }) == all);
    hide->setChecked(has && count([&](int h) { return traits(h).hidden; }) == all);
    link->setChecked(has && linked == all);
}

/// Proposes a name for a new group, so that Enter suffices; existing groups can be chosen.
void PinActions::askGroup() {
    const auto taken = groupNames(m_session.document().design());
    const std::string& own = traitsOf(m_session.document().design(), selected().front()).group;
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
    if (given && !name.isEmpty()) setGroup(m_session.document(), m_session.pins(), selected(), name);
}

void PinActions::askColour() {
    const int first = selected().front();
    const QColor colour =
        QColorDialog::getColor(pinColour(first, traitsOf(m_session.document().design(), first)),
                               QApplication::activeWindow(), tr("Colour of the Pin"));
    if (colour.isValid())
        setColour(m_session.document(), m_session.pins(), selected(), colour.rgb() & 0xFFFFFF);
}

}  // namespace wend
