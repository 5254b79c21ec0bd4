#pragma once

#include <QColor>
#include <QMenu>
#include <QObject>
#include <QPalette>
#include <memory>

#include "app/style/theme.h"
#include "app/window/actions/action_maker.h"

class QActionGroup;
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

/// The background of the shape: checks behind a picture and the workspace behind a solid, or a colour for
/// judging edges; stored in the settings. It does not affect exports.
class BackdropChoice : public ActionMaker {
    Q_OBJECT

  public:
    explicit BackdropChoice(QObject* parent);

    QMenu* menu() const { return m_menu.get(); }
    /// Returns the colour, which is invalid for checks and workspace.
    QColor colour() const;

  signals:
    void changed(const QColor& colour);

  private:
    void choose(const QAction* chosen);

    std::unique_ptr<QMenu> m_menu;
    QActionGroup* m_group;
};

}  // namespace wend
