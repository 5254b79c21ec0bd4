#include "app/view/action_maker.h"

#include "app/panels/theme.h"

namespace wend {

QAction* ActionMaker::add(const Words& words, const QKeySequence& keys, const QString& icon) {
    auto* action = new QAction(words.name, this);
    action->setShortcut(keys);
    action->setProperty("help", words.help);
    action->setProperty("iconName", icon);
    describe(action);
    return action;
}

QAction* ActionMaker::addToggle(const Words& words, const QKeySequence& keys, const QString& icon) {
    QAction* action = add(words, keys, icon);
    action->setCheckable(true);
    return action;
}

void ActionMaker::describe(QAction* action, const QString& extra) {
    const QString help = action->property("help").toString();
    QString name = action->text();
    name.remove('&');
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    const QString keyText =
        keys.isEmpty()
            ? QString()
            : QStringLiteral(" &nbsp;<span style='opacity:0.7'>%1</span>").arg(keys.toHtmlEscaped());
    const QString why =
        extra.isEmpty() ? QString() : QStringLiteral("<p><i>%1</i></p>").arg(extra.toHtmlEscaped());
    action->setToolTip(QStringLiteral("<p><b>%1</b>%2</p><p>%3</p>%4")
                           .arg(name.toHtmlEscaped(), keyText, help.toHtmlEscaped(), why));
    action->setStatusTip(extra.isEmpty() ? help : extra);
}

void ActionMaker::setIcons(const QPalette& palette) {
    for (QAction* action : findChildren<QAction*>())
        if (const QString name = action->property("iconName").toString(); !name.isEmpty()) {
            action->setIcon(wendIcon(name, palette));
            action->setIconVisibleInMenu(false);
        }
}

void ActionMaker::enable(QAction* action, bool enabled, const QString& whyNot) {
    action->setEnabled(enabled);
    describe(action, enabled ? QString() : whyNot);
}

}  // namespace wend
