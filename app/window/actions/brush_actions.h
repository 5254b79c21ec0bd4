#pragma once

#include <QMenu>
#include <memory>

#include "app/session/brush.h"
#include "app/window/actions/action_maker.h"
#include "app/window/actions/number_action.h"

namespace wend {

class Toolbox;

/// The brush's target and tip beside the name of its tool, and a shortcut for each of the four stops; a tool
/// that does not paint is replaced by the brush.
class BrushActions : public ActionMaker {
    Q_OBJECT

  public:
    BrushActions(Brush& brush, Toolbox& tools, QObject* parent);

    QAction *keep = nullptr, *stiffness = nullptr, *direction = nullptr;
    NumberAction *amount = nullptr, *size = nullptr, *hardness = nullptr;
    NumberAction *order = nullptr, *edges = nullptr;  // values of the depth and the detail brush
    QAction* pressure = nullptr;

    QMenu* menu() const { return m_menu.get(); }

  private:
    void makeStops();
    void makeTargets();
    void makeTip();
    void makeNumbers();
    void showBrush();
    void refresh();
    void paint(int stop);

    Brush& m_brush;
    QList<QAction*> m_stops;
    Toolbox& m_tools;
    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
