#include "app/window/help/shortcuts.h"

#include <QAction>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <array>

#include "app/panels/fields/panel_parts.h"
#include "app/window/actions/action_maker.h"
#include "app/window/actions/toolbox.h"
#include "app/window/export/dialogs.h"

namespace wend {

namespace {

constexpr int kColumns = 3;

struct Group {
    QString title;
    QStringList rows;
};

QString row(const QString& keys, const QString& what) {
    return QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
}

QString plain(const QString& name) {
    return withoutKey(name).remove(QStringLiteral("…"));
}

QString keysOf(const QAction& action) {
    const auto own = ActionMaker::keysOf(action);
    return QKeySequence::listToString(own.isEmpty() ? action.shortcuts() : own, QKeySequence::NativeText);
}

/// Submenus are listed with their menu; shortcuts are grouped under its name.
void collect(const QMenu& menu, Group& group) {
    QString section;
    for (const QAction* action : menu.actions()) {
        if (action->isSeparator()) section = plain(action->text());
        if (!action->isVisible() || action->isSeparator()) continue;
        const QString keys = keysOf(*action);
        if (action->menu()) collect(*action->menu(), group);
        if (action->menu() || keys.isEmpty()) continue;
        if (!section.isEmpty())
            group.rows << QStringLiteral("<tr><td></td><td><i>%1</i></td></tr>").arg(section.toHtmlEscaped());
        section.clear();
        group.rows << row(keys, plain(action->text()));
    }
}

Group pointer(int dimension) {
    const auto say = [](const char* text) { return QCoreApplication::translate("CheatSheet", text); };
    Group group{say(QT_TRANSLATE_NOOP("CheatSheet", "Pointer")), {}};
    const auto add = [&](const char* does, const char* what) { group.rows << row(say(does), say(what)); };
    add(QT_TRANSLATE_NOOP("CheatSheet", "Click"), QT_TRANSLATE_NOOP("CheatSheet", "sets a pin"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Drag a pin"),
        QT_TRANSLATE_NOOP("CheatSheet", "moves it; Esc puts it back"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift-click"),
        QT_TRANSLATE_NOOP("CheatSheet", "selects several pins"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Digits while dragging"),
        QT_TRANSLATE_NOOP("CheatSheet", "set the number; Enter confirms it"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Wheel"), QT_TRANSLATE_NOOP("CheatSheet", "zooms to the pointer"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "[ and ]"), QT_TRANSLATE_NOOP("CheatSheet", "size of a brush"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Alt-right-drag a brush"),
        QT_TRANSLATE_NOOP("CheatSheet", "changes its size and hardness"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift-click with the brush"),
        QT_TRANSLATE_NOOP("CheatSheet", "paints a straight line"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Arrow keys without a pin"),
        QT_TRANSLATE_NOOP("CheatSheet", "move a cross, Enter clicks there"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Tap the space bar"),
        QT_TRANSLATE_NOOP("CheatSheet", "plays or pauses; held, it moves the view"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Hold H"),
        QT_TRANSLATE_NOOP("CheatSheet", "hides pins and overlays"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Hold \\"),
        QT_TRANSLATE_NOOP("CheatSheet", "shows the shape before it was bent"));
    if (dimension == 3) {
        add(QT_TRANSLATE_NOOP("CheatSheet", "X, Y, Z while dragging"),
            QT_TRANSLATE_NOOP("CheatSheet", "lock an axis"));
        add(QT_TRANSLATE_NOOP("CheatSheet", "Right or middle button"),
            QT_TRANSLATE_NOOP("CheatSheet", "turns the view; with Shift, moves it"));
        add(QT_TRANSLATE_NOOP("CheatSheet", "Middle click"),
            QT_TRANSLATE_NOOP("CheatSheet", "sets the point to turn around"));
        return group;
    }
    add(QT_TRANSLATE_NOOP("CheatSheet", "Ctrl+Shift-drag a pin"),
        QT_TRANSLATE_NOOP("CheatSheet", "widens it to a circle"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Drag the ring's dot or square"),
        QT_TRANSLATE_NOOP("CheatSheet", "rotates or scales; Shift snaps to 15°"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Arrow keys"),
        QT_TRANSLATE_NOOP("CheatSheet", "nudge by a pixel, with Shift by ten"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Middle button"), QT_TRANSLATE_NOOP("CheatSheet", "pans"));
    return group;
}

/// Returns the keys of the tracks, which are in no menu of the window.
Group tracks() {
    const auto say = [](const char* text) { return QCoreApplication::translate("CheatSheet", text); };
    Group group{say(QT_TRANSLATE_NOOP("CheatSheet", "Tracks")), {}};
    const auto add = [&](const char* does, const char* what) { group.rows << row(say(does), say(what)); };
    add(QT_TRANSLATE_NOOP("CheatSheet", "Up, Down"), QT_TRANSLATE_NOOP("CheatSheet", "choose a pin"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Left, Right"), QT_TRANSLATE_NOOP("CheatSheet", "show another time"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Alt+Left, Alt+Right"),
        QT_TRANSLATE_NOOP("CheatSheet", "move the chosen bars or keys"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift-click, or a frame"),
        QT_TRANSLATE_NOOP("CheatSheet", "chooses several"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "E"), QT_TRANSLATE_NOOP("CheatSheet", "opens their easing curve"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Ctrl+C, Ctrl+V"),
        QT_TRANSLATE_NOOP("CheatSheet", "copy keys, paste them at the time shown"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Ctrl+Shift+V"),
        QT_TRANSLATE_NOOP("CheatSheet", "pastes them mirrored"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Del"), QT_TRANSLATE_NOOP("CheatSheet", "removes them"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "I, O"),
        QT_TRANSLATE_NOOP("CheatSheet", "begin and end the cycle here"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift-drag the numbers"),
        QT_TRANSLATE_NOOP("CheatSheet", "marks the cycle"));
    add(QT_TRANSLATE_NOOP("CheatSheet", "Shift+M"), QT_TRANSLATE_NOOP("CheatSheet", "adds a marker"));
    return group;
}

constexpr int kAction = Qt::UserRole;

/// Keys that the views and the tools read themselves.
bool isFixed(const QKeyCombination& keys) {
    if (keys.keyboardModifiers() & ~Qt::ShiftModifier) return false;
    constexpr std::array kFixed = {
        Qt::Key_Escape,    Qt::Key_Tab,         Qt::Key_Backtab,      Qt::Key_Return,    Qt::Key_Enter,
        Qt::Key_Space,     Qt::Key_Left,        Qt::Key_Right,        Qt::Key_Up,        Qt::Key_Down,
        Qt::Key_Backslash, Qt::Key_BracketLeft, Qt::Key_BracketRight, Qt::Key_BraceLeft, Qt::Key_BraceRight};
    const bool isHeld = keys.key() == Qt::Key_H && !keys.keyboardModifiers();
    return isHeld || std::ranges::find(kFixed, keys.key()) != kFixed.end();
}

QString nameOf(const QAction& action) {
    return withoutKey(action.text()).remove(QStringLiteral("…"));
}

QAction* actionOf(const QTreeWidgetItem& item) {
    return item.data(0, kAction).value<QAction*>();
}

}  // namespace

QString CheatSheet::text(const QMenuBar& menus, int dimension) {
    QList<Group> groups = {pointer(dimension), tracks()};
    for (const QAction* menu : menus.actions()) {
        if (!menu->isVisible() || !menu->menu()) continue;
        Group group{plain(menu->text()), {}};
        collect(*menu->menu(), group);
        if (!group.rows.isEmpty()) groups << group;
    }
    // The longest ones first, each into the column that is shortest.
    std::stable_sort(groups.begin(), groups.end(),
                     [](const Group& a, const Group& b) { return a.rows.size() > b.rows.size(); });
    QStringList columns(kColumns);
    std::array<qsizetype, kColumns> heights{};
    for (const Group& group : groups) {
        const auto at = std::min_element(heights.begin(), heights.end());
        *at += group.rows.size() + 2;
        columns[at - heights.begin()] += QStringLiteral("<h4>%1</h4><table cellspacing='3'>%2</table>")
                                             .arg(group.title.toHtmlEscaped(), group.rows.join(QString()));
    }
    return QStringLiteral("<table width='100%'><tr><td>%1</td></tr></table>")
        .arg(columns.join(QStringLiteral("</td><td>&nbsp;&nbsp;</td><td>")));
}

CheatSheet::CheatSheet(const QMenuBar& menus, int dimension, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Keys and Mouse"));
    auto* sheet = new QTextBrowser(this);
    sheet->setHtml(text(menus, dimension));
    sheet->setFrameShape(QFrame::NoFrame);
    sheet->setAccessibleName(windowTitle());
    auto* column = new QVBoxLayout(this);
    column->addWidget(sheet, 1);
    column->addWidget(dialogButtons(QDialogButtonBox::Close, this));
    resize(QSize(1060, 700).boundedTo(parent->size()));
}

ShortcutDialog::ShortcutDialog(const QMenuBar& menus, Toolbox& tools, QWidget* parent)
    : QDialog(parent),
      m_tools(tools),
      m_list(new QTreeWidget(this)),
      m_edit(new QKeySequenceEdit(this)),
      m_none(new QPushButton(tr("&None"), this)),
      m_standard(new QPushButton(tr("&Standard"), this)),
      m_note(new QLabel(this)) {
    setWindowTitle(tr("Keyboard Shortcuts"));
    auto* filter = new QLineEdit(this);
    filter->setPlaceholderText(tr("Search for an action or for keys"));
    filter->setAccessibleName(filter->placeholderText());
    filter->setClearButtonEnabled(true);
    connect(filter, &QLineEdit::textChanged, this, &ShortcutDialog::search);
    fill(menus);
    QDialogButtonBox* buttons = dialogButtons(QDialogButtonBox::Close, this);
    auto* all = buttons->addButton(tr("&All Standard"), QDialogButtonBox::ResetRole);
    all->setToolTip(tr("Give every action the keys that it has in a new Wend"));
    connect(all, &QPushButton::clicked, this, &ShortcutDialog::restoreAll);
    m_note->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->addWidget(filter);
    column->addWidget(m_list, 1);
    column->addWidget(makeRow());
    column->addWidget(m_note);
    column->addWidget(buttons);
    for (QPushButton* button : findChildren<QPushButton*>()) button->setAutoDefault(false);
    showChosen();
    resize(QSize(520, 640).boundedTo(parent->size()));
}

QWidget* ShortcutDialog::makeRow() {
    auto* row = new QWidget(this);
    auto* label = new QLabel(tr("&Keys"), row);
    label->setBuddy(m_edit);
    m_edit->setAccessibleName(tr("Keys"));
    m_edit->setToolTip(tr("Click here, then press the keys"));
    m_none->setToolTip(tr("Leave the chosen action without keys"));
    m_standard->setToolTip(tr("Give the chosen action the keys that it has in a new Wend"));
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(label);
    line->addWidget(m_edit, 1);
    line->addWidget(m_none);
    line->addWidget(m_standard);
    connect(m_edit, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutDialog::take);
    connect(m_none, &QPushButton::clicked, this, [this] { assign(*chosen(), {}); });
    connect(m_standard, &QPushButton::clicked, this,
            [this] { assign(*chosen(), ActionMaker::standardKeysOf(*chosen())); });
    return row;
}

/// Lists the actions of a menu and of its submenus that have a name in the settings.
void ShortcutDialog::fill(const QMenuBar& menus) {
    m_list->setColumnCount(2);
    m_list->setHeaderLabels({tr("Action"), tr("Keys")});
    m_list->setAccessibleName(tr("Actions"));
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    const QList<QAction*> known = m_tools.actionsWithKeys();
    const auto add = [&](const auto& self, QTreeWidgetItem& heading, const QMenu& menu,
                         const QString& path) -> void {
        for (QAction* action : menu.actions()) {
            if (action->menu())
                self(self, heading, *action->menu(), path + nameOf(*action) + QStringLiteral(" › "));
            if (!known.contains(action)) continue;
            auto* item = new QTreeWidgetItem(&heading, {path + nameOf(*action)});
            item->setData(0, kAction, QVariant::fromValue(action));
            item->setToolTip(0, ActionMaker::helpOf(*action));
        }
    };
    for (const QAction* menu : menus.actions()) {
        auto* heading = new QTreeWidgetItem(m_list, {nameOf(*menu)});
        heading->setFlags(Qt::ItemIsEnabled);
        add(add, *heading, *menu->menu(), {});
        heading->setHidden(heading->childCount() == 0);
    }
    m_list->expandAll();
    showKeys();
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ShortcutDialog::showChosen);
}

void ShortcutDialog::search(const QString& text) {
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        QTreeWidgetItem& heading = *m_list->topLevelItem(i);
        bool any = false;
        for (int k = 0; k < heading.childCount(); ++k) {
            QTreeWidgetItem& item = *heading.child(k);
            const bool found = item.text(0).contains(text, Qt::CaseInsensitive) ||
                               item.text(1).contains(text, Qt::CaseInsensitive);
            item.setHidden(!found);
            any |= found;
        }
        heading.setHidden(!any);
    }
}

QAction* ShortcutDialog::chosen() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    return item ? actionOf(*item) : nullptr;
}

void ShortcutDialog::showChosen() {
    const QAction* action = chosen();
    for (QWidget* part :
         {static_cast<QWidget*>(m_edit), static_cast<QWidget*>(m_none), static_cast<QWidget*>(m_standard)})
        part->setEnabled(action != nullptr);
    const QSignalBlocker quiet(m_edit);
    m_edit->setKeySequence(action ? ActionMaker::keysOf(*action).value(0) : QKeySequence());
    m_note->setText(action ? QString() : tr("Choose an action, then press the keys that it shall have."));
}

void ShortcutDialog::showKeys() {
    for (QTreeWidgetItemIterator at(m_list); *at; ++at)
        if (const QAction* action = actionOf(**at)) {
            const QList<QKeySequence> keys = ActionMaker::keysOf(*action);
            (*at)->setText(1, QKeySequence::listToString(keys, QKeySequence::NativeText));
            QFont font = (*at)->font(1);
            font.setBold(keys != ActionMaker::standardKeysOf(*action));
            (*at)->setFont(1, font);
        }
}

/// Takes the first of up to four key presses that the field collects; by value, since the field is set anew.
void ShortcutDialog::take(QKeySequence typed) {
    if (typed.isEmpty() || !chosen()) return;
    if (typed == ActionMaker::keysOf(*chosen()).value(0)) return;  // repeated when the field loses the focus
    if (isFixed(typed[0])) {
        showChosen();
        m_note->setText(tr("%1 cannot be chosen: the canvas uses it.")
                            .arg(QKeySequence(typed[0]).toString(QKeySequence::NativeText)));
        return;
    }
    assign(*chosen(), {QKeySequence(typed[0])});
}

void ShortcutDialog::assign(QAction& action, const QList<QKeySequence>& keys) {
    QStringList losers;
    for (QAction* other : m_tools.actionsWithKeys()) {
        if (other == &action || m_tools.canShareKeys(*other, action)) continue;
        QList<QKeySequence> left = ActionMaker::keysOf(*other);
        if (left.removeIf([&](const QKeySequence& key) { return keys.contains(key); }) == 0) continue;
        ActionMaker::chooseKeysOf(*other, left);
        losers << tr("“%1”").arg(nameOf(*other));
    }
    ActionMaker::chooseKeysOf(action, keys);
    m_tools.shareKeys();
    showKeys();
    showChosen();
    if (!losers.isEmpty()) m_note->setText(tr("Taken from %1.").arg(losers.join(QStringLiteral(", "))));
}

void ShortcutDialog::restoreAll() {
    for (QAction* action : m_tools.actionsWithKeys()) ActionMaker::chooseKeysOf(*action, std::nullopt);
    m_tools.shareKeys();
    showKeys();
    showChosen();
}

}  // namespace wend
