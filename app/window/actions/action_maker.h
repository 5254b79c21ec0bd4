#pragma once

#include <QAction>
#include <QObject>
#include <optional>

namespace wend {

/// Makes actions with name, shortcut and help. The tooltip of a disabled action gives the reason.
class ActionMaker : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    void setIcons(const QPalette& palette);
    /// The actions that were made here, in that order.
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
