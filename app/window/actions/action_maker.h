#pragma once

#include <QActionGroup>
#include <QKeySequence>
#include <concepts>
#include <optional>
#include <vector>

namespace wend {

/// Connects actions with what they do when they are triggered: each with a slot of `receiver`, a member
/// function or a callable:
///
///     onTriggered(files, actions.open, &FileWorkflow::askOpen, actions.save, &FileWorkflow::save);
template <class Receiver, class Slot, class... More>
void onTriggered(Receiver* receiver, const QAction* action, const Slot& slot, const More&... more) {
    QObject::connect(action, &QAction::triggered, receiver, slot);
    if constexpr (sizeof...(more) > 0) onTriggered(receiver, more...);
}

/// Does the same for actions that are switched.
template <class Receiver, class Slot, class... More>
void onToggled(Receiver* receiver, const QAction* action, const Slot& slot, const More&... more) {
    QObject::connect(action, &QAction::toggled, receiver, slot);
    if constexpr (sizeof...(more) > 0) onToggled(receiver, more...);
}

template <class Slot>
concept ActionSlot = std::invocable<Slot> || std::invocable<Slot, bool>;

/// Makes actions with name, shortcut and help. The tooltip of a disabled action gives the reason.
class ActionMaker : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    void setIcons(const QPalette& palette);
    /// Returns the actions that were made here, in order of creation.
    QList<QAction*> own() const { return m_own; }
    /// Returns the help of an action; empty for actions not made here.
    static QString helpOf(const QAction& action) { return action.property("help").toString(); }
    /// Returns the keys of an action that apply unless another action needs them: those that the user chose,
    /// or the standard ones.
    static QList<QKeySequence> keysOf(const QAction& action);
    static QList<QKeySequence> standardKeysOf(const QAction& action);
    /// Remembers the user's keys for an action, or, with none given, forgets them.
    static void chooseKeysOf(QAction& action, const std::optional<QList<QKeySequence>>& keys);

  protected:
    struct Words {
        QString name, help;
    };
    /// `id` names the action among those of this maker, for the keys that the user chooses.
    QAction* add(QAnyStringView id, const Words& words, const QKeySequence& keys, const QString& icon = {});
    QAction* addToggle(QAnyStringView id, const Words& words, const QKeySequence& keys,
                       const QString& icon = {});
    /// Make an action that calls a slot when it is triggered.
    template <ActionSlot Slot>
    QAction* add(QAnyStringView id, const Words& words, const QKeySequence& keys, const Slot& slot) {
        QAction* action = add(id, words, keys);
        onTriggered(this, action, slot);
        return action;
    }
    template <ActionSlot Slot>
    QAction* addToggle(QAnyStringView id, const Words& words, const QKeySequence& keys, const Slot& slot) {
        QAction* action = addToggle(id, words, keys);
        onTriggered(this, action, slot);
        return action;
    }
    /// Lets one of these actions be checked at a time.
    QActionGroup* oneOf(const QList<QAction*>& actions);
    /// Does the same, and passes the value of the action that becomes checked.
    template <class Value, class Take>
    void choose(const std::vector<std::pair<QAction*, Value>>& choices, const Take& take) {
        auto* group = oneOf({});
        for (const auto& [action, value] : choices)
            connect(group->addAction(action), &QAction::toggled, this, [take, value = value](bool on) {
                if (on) take(value);
            });
    }
    /// Takes an action that Qt made among the own ones.
    void adopt(QAction* action, QAnyStringView id, const QList<QKeySequence>& keys);
    /// Gives an action other words.
    static void reword(QAction* action, const Words& words);
    void enable(QAction* action, bool enabled, const QString& whyNot);
    /// Sets the standard keys.
    static void setKeysOf(QAction* action, const QList<QKeySequence>& keys);
    /// Assigns the keys that currently apply.
    static void useKeys(QAction* action, const QList<QKeySequence>& keys);

  private:
    static void describe(QAction* action);

    QList<QAction*> m_own;
};

}  // namespace wend
