#pragma once

#include "app/tools/outline_settings.h"
#include "app/view/action_maker.h"
#include "app/view/number_action.h"

namespace wend {

/// What stands beside the tools of pictures: pins, those of the outline, and the brushes for depth and
/// detail.
class PictureActions : public ActionMaker {
    Q_OBJECT

  public:
    explicit PictureActions(QObject* parent);

    QAction *adds, *takesAway;
    NumberAction *size, *tolerance;
    NumberAction *order, *edges;
    QAction* snap;

    OutlinePen& pen() { return m_pen; }
    const PenValue& depth() const { return m_depth; }
    const PenValue& fineness() const { return m_fineness; }

  private:
    void makeBrushes();
    void showPen();

    OutlinePen m_pen;
    PenValue m_depth{1}, m_fineness{0.5};
};

}  // namespace wend
