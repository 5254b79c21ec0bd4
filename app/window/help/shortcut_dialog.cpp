#include "app/window/help/shortcut_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <array>

#include "app/panels/fields/panel_parts.h"
#include "app/window/actions/toolbox.h"

namespace wend {

namespace {

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
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* all = buttons->addButton(tr("&All Standard"), QDialogButtonBox::ResetRole);
    all->setToolTip(tr("Give every action the keys that it has in a new Wend"));
    connect(all, &QPushButton::clicked, this, &ShortcutDialog::restoreAll);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
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
