#pragma once

#include <QAction>
#include <QObject>

namespace wend {

/// Makes actions with name, shortcut and explanation. What a disabled action waits for stands in its tooltip.
class ActionMaker : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    void setIcons(const QPalette& palette);
    /// The actions that were made here, in that order.
    QList<QAction*> own() const { return m_own; }
    /// What an action does, in a sentence; empty for what is not made here.
    static QString helpOf(const QAction& action) { return action.property("help").toString(); }
    /// The keys that it has where no other action that is more at hand wants them.
    static QList<QKeySequence> keysOf(const QAction& action);

  protected:
    struct Words {
        QString name, help;
    };
    QAction* add(const Words& words, const QKeySequence& keys, const QString& icon = {});
    QAction* addToggle(const Words& words, const QKeySequence& keys, const QString& icon = {});
    /// The same action in other words.
    static void reword(QAction* action, const Words& words);
    void enable(QAction* action, bool enabled, const QString& whyNot);
    static void setKeysOf(QAction* action, const QList<QKeySequence>& keys);
    /// Those of them that it has now.
    static void useKeys(QAction* action, const QList<QKeySequence>& keys);

  private:
    static void describe(QAction* action);

    QList<QAction*> m_own;
};

}  // namespace wend
