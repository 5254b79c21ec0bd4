#pragma once

#include <QMenu>
#include <memory>

#include "app/tools/pin_settings.h"
#include "app/view/actions/action_maker.h"

namespace wend {

class NumberAction;
class ShapeSession;

/// What can be done with the selected pins, of pictures and of solids; among it what a drag does with them.
class PinActions : public ActionMaker {
    Q_OBJECT

  public:
    PinActions(ShapeSession& session, QObject* parent);

    QAction *move, *turn, *grow;
    QAction *selectRectangle, *selectLasso, *selectBrush;  // what is drawn beside pins
    QAction* snap;
    NumberAction* brushSize;  // of the brush that takes hold of what it covers
    QAction *lock, *hide, *showAll;
    QAction *group, *ungroup, *link;
    QAction *mirror, *mirrorMotion;
    QAction* holdThroughout;

    QMenu* menu() const { return m_menu.get(); }
    PinChoice& choice() { return m_choice; }
    /// What a pin's own menu holds of it.
    void fill(QMenu& menu) const;

  private:
    void makeGrips();
    void makeOutlines();
    template <class Value>
    void choose(Value PinSettings::*value, std::initializer_list<std::pair<QAction*, Value>> choices);
    void makeActions();
    void makeColours();
    void connectActions();
    void refresh();
    const std::vector<int>& selected() const;
    void askGroup();
    void askColour();

    ShapeSession& m_session;
    PinChoice m_choice;
    std::unique_ptr<QMenu> m_menu, m_colours;
};

}  // namespace wend
