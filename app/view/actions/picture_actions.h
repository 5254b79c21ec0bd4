#pragma once

#include "app/tools/outline_settings.h"
#include "app/view/actions/action_maker.h"
#include "app/view/actions/number_action.h"

namespace wend {

/// What stands beside the tools that draw the outline of a picture.
class PictureActions : public ActionMaker {
    Q_OBJECT

  public:
    explicit PictureActions(QObject* parent);

    QAction *adds, *takesAway;
    NumberAction *size, *tolerance;

    OutlinePen& pen() { return m_pen; }

  private:
    void showPen();

    OutlinePen m_pen;
};

}  // namespace wend
