#pragma once

#include <QMenu>
#include <memory>

#include "app/view/action_maker.h"

namespace wend {

class ShapeSession;

/// What can be done with the selected pins, of pictures and of solids; among it what a drag does with them.
class PinActions : public ActionMaker {
    Q_OBJECT

  public:
    PinActions(ShapeSession& session, QObject* parent);

    QAction *move, *turn, *grow;
    QAction *selectRectangle, *selectLasso, *selectBrush;  // what is drawn beside pins
    QAction *lock, *hide, *showAll;
    QAction *group, *ungroup, *link;
    QAction *mirror, *mirrorMotion;
    QAction* holdThroughout;

    QMenu* menu() const { return m_menu.get(); }
    /// What a pin's own menu holds of it.
    void fill(QMenu& menu) const;

  private:
    void makeGrips();
    void makeOutlines();
    void makeActions();
    void makeColours();
    void connectActions();
    void refresh();
    const std::vector<int>& selected() const;
    void askGroup();
    void askColour();

    ShapeSession& m_session;
    std::unique_ptr<QMenu> m_menu, m_colours;
};

}  // namespace wend
