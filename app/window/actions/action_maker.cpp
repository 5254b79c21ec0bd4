#include "app/window/actions/action_maker.h"

#include "app/base/preferences.h"
#include "app/panels/fields/panel_parts.h"
#include "app/style/theme.h"

namespace wend {

namespace {

/// Returns the preference for the action's keys, named by the class of its maker and the action, as in
/// "Actions/open".
Preference<QStringList> chosenKeys(const QAction& action) {
    QString maker = QString::fromLatin1(action.parent()->metaObject()->className());
    maker.remove(QStringLiteral("wend::"));
    return Preference<QStringList>(QStringLiteral("keys/%1/%2").arg(maker, action.objectName()));
}

}  // namespace

QAction* ActionMaker::add(QAnyStringView id, const Words& words, const QKeySequence& keys,
                          const QString& icon) {
    auto* action = new QAction(words.name, this);
    action->setProperty("help", words.help);
    action->setProperty("iconName", icon);
    action->setShortcut(keys);
    adopt(action, id, action->shortcuts());
    describe(action);
    return action;
}

void ActionMaker::adopt(QAction* action, QAnyStringView id, const QList<QKeySequence>& keys) {
    action->setObjectName(id.toString());
    setKeysOf(action, keys);
    m_own << action;
}

QAction* ActionMaker::addToggle(QAnyStringView id, const Words& words, const QKeySequence& keys,
                                const QString& icon) {
    QAction* action = add(id, words, keys, icon);
    action->setCheckable(true);
    return action;
}

QActionGroup* ActionMaker::oneOf(const QList<QAction*>& actions) {
    auto* group = new QActionGroup(this);
    for (QAction* action : actions) group->addAction(action);
    return group;
}

/// Sets the tooltip; the reason for a disabled action is its first line.
void ActionMaker::describe(QAction* action) {
    if (!action->property("help").isValid()) return;  // of Qt, which rewords it
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
    const QString why = enabled ? QString() : whyNot;
    if (action->isEnabled() == enabled && action->property("whyNot").toString() == why) return;
    action->setEnabled(enabled);
    action->setProperty("whyNot", why);
    describe(action);
}

QList<QKeySequence> ActionMaker::keysOf(const QAction& action) {
    return action.property("ownKeys").value<QList<QKeySequence>>();
}

QList<QKeySequence> ActionMaker::standardKeysOf(const QAction& action) {
    return action.property("standardKeys").value<QList<QKeySequence>>();
}

void ActionMaker::setKeysOf(QAction* action, const QList<QKeySequence>& keys) {
    action->setProperty("standardKeys", QVariant::fromValue(keys));
    const Preference<QStringList> chosen = chosenKeys(*action);
    QList<QKeySequence> own = keys;
    if (chosen.isSet()) {
        own.clear();
        for (const QString& key : chosen.value()) own << QKeySequence(key, QKeySequence::PortableText);
    }
    action->setProperty("ownKeys", QVariant::fromValue(own));
    useKeys(action, own);
}

void ActionMaker::chooseKeysOf(QAction& action, const std::optional<QList<QKeySequence>>& keys) {
    const Preference<QStringList> chosen = chosenKeys(action);
    if (!keys || *keys == standardKeysOf(action)) {
        chosen.forget();
    } else {
        QStringList texts;
        for (const QKeySequence& key : *keys) texts << key.toString(QKeySequence::PortableText);
        chosen.set(texts);
    }
    setKeysOf(&action, standardKeysOf(action));
}

void ActionMaker::useKeys(QAction* action, const QList<QKeySequence>& keys) {
    if (action->shortcuts() == keys) return;
    action->setShortcuts(keys);
    describe(action);
}

}  // namespace wend
