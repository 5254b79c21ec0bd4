#pragma once

#include <QAction>
#include <QObject>

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
    /// Returns the keys of an action that apply unless another action needs them.
    static QList<QKeySequence> keysOf(const QAction& action);

  protected:
    struct Words {
        QString name, help;
    };
    QAction* add(const Words& words, const QKeySequence& keys, const QString& icon = {});
    QAction* addToggle(const Words& words, const QKeySequence& keys, const QString& icon = {});
    /// Gives an action other words.
    static void reword(QAction* action, const Words& words);
    void enable(QAction* action, bool enabled, const QString& whyNot);
    static void setKeysOf(QAction* action, const QList<QKeySequence>& keys);
    /// Assigns the keys that currently apply.
    static void useKeys(QAction* action, const QList<QKeySequence>& keys);

  private:
    static void describe(QAction* action);

    QList<QAction*> m_own;
};

}  // namespace wend
