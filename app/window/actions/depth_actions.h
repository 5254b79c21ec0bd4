#pragma once

#include <QMenu>
#include <memory>

#include "app/window/actions/action_maker.h"

namespace wend {

class ShapeSession;

/// Sets the depth of the surroundings of selected pins.
class DepthActions : public ActionMaker {
    Q_OBJECT

  public:
    DepthActions(ShapeSession& session, QObject* parent);

    QAction *front, *behind, *plain, *number;

    QMenu* menu() const { return m_menu.get(); }

  private:
    void refresh();
    void bring(double order);
    void askNumber();

    ShapeSession& m_session;
    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
