#pragma once

#include <QMenu>
#include <functional>
#include <memory>

#include "app/tools/pin_settings.h"
#include "app/window/actions/action_maker.h"

namespace wend {

class CurveEditor;
class Document;
class NumberAction;
class ShapeSession;
class ShownPins;

/// Commands for the selected pins of pictures and solids, including the effect of a drag.
class PinActions : public ActionMaker {
    Q_OBJECT

  public:
    PinActions(ShapeSession& session, QObject* parent);

    QAction *move, *turn, *grow;
    QAction *selectRectangle, *selectLasso, *selectBrush;  // shape of the marquee
    QAction* snap;
    NumberAction* brushSize;  // of the brush that grabs an area
    QAction *lock, *hide, *showAll;
    QAction *group, *ungroup, *link;
    QAction *mirror, *mirrorMotion;
    QAction* holdThroughout;

    QMenu* menu() const { return m_menu.get(); }
    PinChoice& choice() { return m_choice; }
    /// Returns the name of the selected pin, or the number of selected pins.
    QString selectedName() const;
    /// Adds these commands to a pin's context menu.
    void fill(QMenu& menu) const;
    /// Updates which commands are possible.
    void refresh();

  private:
    void makeGrips();
    void makeOutlines();
    void makeActions();
    void makeColours();
    std::vector<int> selected() const;
    std::vector<int> hidden() const;
    void askGroup();
    void askColour();

    ShapeSession& m_session;
    Document& m_document;
    const ShownPins& m_shown;
    PinChoice m_choice;
    std::unique_ptr<QMenu> m_menu, m_colours;
};

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
