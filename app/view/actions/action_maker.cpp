#include "app/view/actions/action_maker.h"

#include "app/panels/fields/panel_parts.h"
#include "app/panels/look/theme.h"

namespace wend {

QAction* ActionMaker::add(const Words& words, const QKeySequence& keys, const QString& icon) {
    auto* action = new QAction(words.name, this);
    action->setProperty("help", words.help);
    action->setProperty("iconName", icon);
    action->setShortcut(keys);
    setKeysOf(action, action->shortcuts());
    describe(action);
    m_own << action;
    return action;
}

QAction* ActionMaker::addToggle(const Words& words, const QKeySequence& keys, const QString& icon) {
    QAction* action = add(words, keys, icon);
    action->setCheckable(true);
    return action;
}

/// The reason for a disabled action is the first line of its tooltip.
void ActionMaker::describe(QAction* action) {
    const QString help = helpOf(*action), extra = action->property("whyNot").toString();
    const QString name = withoutKey(action->text());
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    const QString keyText =
        keys.isEmpty()
            ? QString()
            : QStringLiteral(" &nbsp;<span style='opacity:0.7'>%1</span>").arg(keys.toHtmlEscaped());
    const QString why =
        extra.isEmpty() ? QString() : QStringLiteral("<p><i>%1</i></p>").arg(extra.toHtmlEscaped());
    action->setToolTip(QStringLiteral("%1<p><b>%2</b>%3</p><p>%4</p>")
                           .arg(why, name.toHtmlEscaped(), keyText, help.toHtmlEscaped()));
    action->setStatusTip(extra.isEmpty() ? help : extra);
    action->setIconText(name);  // Qt leaves a letter in brackets in buttons
}

void ActionMaker::setIcons(const QPalette& palette) {
    for (QAction* action : findChildren<QAction*>())
        if (const QString name = action->property("iconName").toString(); !name.isEmpty()) {
            action->setIcon(wendIcon(name, palette));
            action->setIconVisibleInMenu(false);
        }
}

void ActionMaker::reword(QAction* action, const Words& words) {
    action->setText(words.name);
    action->setProperty("help", words.help);
    describe(action);
}

void ActionMaker::enable(QAction* action, bool enabled, const QString& whyNot) {
    action->setEnabled(enabled);
    action->setProperty("whyNot", enabled ? QString() : whyNot);
    describe(action);
}

QList<QKeySequence> ActionMaker::keysOf(const QAction& action) {
    return action.property("ownKeys").value<QList<QKeySequence>>();
}

void ActionMaker::setKeysOf(QAction* action, const QList<QKeySequence>& keys) {
    action->setProperty("ownKeys", QVariant::fromValue(keys));
    useKeys(action, keys);
}

void ActionMaker::useKeys(QAction* action, const QList<QKeySequence>& keys) {
    if (action->shortcuts() == keys) return;
    action->setShortcuts(keys);
    describe(action);
}

}  // namespace wend
