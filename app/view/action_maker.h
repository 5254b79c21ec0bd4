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

  protected:
    struct Words {
        QString name, help;
    };
    QAction* add(const Words& words, const QKeySequence& keys, const QString& icon = {});
    QAction* addToggle(const Words& words, const QKeySequence& keys, const QString& icon = {});
    void enable(QAction* action, bool enabled, const QString& whyNot);
    void describe(QAction* action, const QString& extra = {});
};

}  // namespace wend
