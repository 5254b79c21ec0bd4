#pragma once

#include <QMenu>
#include <memory>

#include "app/window/actions/action_maker.h"

namespace wend {

class Document;
class Selection;
class ShapeMotion;

/// Sets the depth of the surroundings of selected pins.
class DepthActions : public ActionMaker {
    Q_OBJECT

  public:
    DepthActions(Document& document, const Selection& selection, const ShapeMotion& motion, QObject* parent);

    QAction *front, *behind, *plain, *number;

    QMenu* menu() const { return m_menu.get(); }

    /// Updates which commands are possible.
    void refresh();

  private:
    void bring(double order);
    void askNumber();

    Document& m_document;
    const Selection& m_selection;
    const ShapeMotion& m_motion;
    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
