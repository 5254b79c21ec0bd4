#pragma once

#include <QMenu>
#include <memory>

#include "app/session/brush.h"
#include "app/view/action_maker.h"

namespace wend {

class Toolbox;

/// What the brush paints, by a key: each of the four stops of what is kept. A tool that does not paint gives
/// way to the brush.
class BrushActions : public ActionMaker {
    Q_OBJECT

  public:
    BrushActions(Brush& brush, Toolbox& tools, QObject* parent);

    QMenu* menu() const { return m_menu.get(); }

  private:
    void refresh();
    void choose(int stop);

    Brush& m_brush;
    Toolbox& m_tools;
    std::unique_ptr<QMenu> m_menu;
};

}  // namespace wend
