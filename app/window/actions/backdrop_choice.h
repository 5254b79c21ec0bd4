#pragma once

#include <QColor>
#include <QMenu>
#include <memory>

#include "app/window/actions/action_maker.h"

class QActionGroup;

namespace wend {

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
