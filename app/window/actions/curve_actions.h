#pragma once

#include <QMenu>
#include <functional>
#include <memory>

#include "app/tools/pins/curve_editor.h"
#include "app/window/actions/action_maker.h"

namespace wend {

class ShapeSession;

/// Commands for the curve of a handle, in pictures and solids.
class CurveActions : public ActionMaker {
    Q_OBJECT

  public:
    /// `current`: the curve of the tool that is chosen; null without one.
    CurveActions(ShapeSession& session, std::function<CurveEditor*()> current, QObject* parent);

    QAction *make, *insert, *remove;
    QAction *free, *aligned, *automatic;

    QMenu* menu() const { return m_menu.get(); }

  public slots:
    /// Updates which commands are possible.
    void refresh();
    /// Shows the menu for the item under the pointer.
    void popUp(const QPoint& global);

  private:
    void makeActions();

    ShapeSession& m_session;
    std::function<CurveEditor*()> m_current;
    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
