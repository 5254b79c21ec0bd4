#pragma once

#include <QMenu>
#include <functional>
#include <memory>

#include "app/tools/pins/curve_editing.h"
#include "app/view/actions/action_maker.h"

namespace wend {

class ShapeSession;

/// What can be done with the curve that a handle follows, of pictures and of solids.
class CurveActions : public ActionMaker {
    Q_OBJECT

  public:
    /// `current`: the curve of the tool that is chosen; null without one.
    CurveActions(ShapeSession& session, std::function<CurveEditing*()> current, QObject* parent);

    QAction *make, *insert, *remove;
    QAction *free, *aligned, *automatic;

    QMenu* menu() const { return m_menu.get(); }

  public slots:
    /// What is possible now.
    void refresh();
    /// The menu for what is under the pointer.
    void popUp(const QPoint& global);

  private:
    void makeActions();
    void connectActions();

    ShapeSession& m_session;
    std::function<CurveEditing*()> m_current;
    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
