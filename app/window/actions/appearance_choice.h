#pragma once

#include <QObject>
#include <QPalette>

#include "app/style/theme.h"

class QWidget;

namespace wend {

class Actions;

/// Light, dark or as the desktop, and the size of marks; remembered in the settings.
class AppearanceChoice : public QObject {
    Q_OBJECT

  public:
    AppearanceChoice(Actions& actions, QWidget& window);
    /// Restores the stored choice.
    void restore();

  signals:
    /// Emitted when the palette changed, so that cached drawings must be renewed.
    void changed();

  private:
    void apply(Appearance appearance);
    void restoreMarks();
    void enlargeMarks(double factor);

    Actions& m_actions;
    QWidget& m_window;
    QPalette m_system;
};

}  // namespace wend
