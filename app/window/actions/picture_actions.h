#pragma once

#include "app/tools/outline_settings.h"
#include "app/window/actions/action_maker.h"
#include "app/window/actions/number_action.h"

namespace wend {

/// Options beside the outline tools.
class PictureActions : public ActionMaker {
    Q_OBJECT

  public:
    explicit PictureActions(QObject* parent);

    QAction *adds, *takesAway, *makesPart;
    NumberAction *size, *tolerance;

    OutlinePen& pen() { return m_pen; }

  private:
    void showPen();

    OutlinePen m_pen;
};

}  // namespace wend
