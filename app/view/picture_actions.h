#pragma once

#include "app/session/brush.h"
#include "app/tools/outline_settings.h"
#include "app/view/action_maker.h"

class QSpinBox;
class QWidgetAction;

namespace wend {

/// What stands beside the tools of pictures: pins, those of the outline, and the brushes for depth and
/// detail; and beside those that paint, of solids too.
class PictureActions : public ActionMaker {
    Q_OBJECT

  public:
    PictureActions(Brush& brush, QObject* parent);

    QAction *adds, *takesAway;
    QWidgetAction *size, *tolerance;
    QWidgetAction *order, *edges;
    QAction *snap, *pressure;

    OutlinePen& pen() { return m_pen; }
    const PenValue& depth() const { return m_depth; }
    const PenValue& fineness() const { return m_fineness; }

  private:
    QWidgetAction* number(const QString& name, const QString& help, QSpinBox*& box, const QString& unit);
    void makeBrushes();
    void makeSwitches(Brush& brush);
    void showPen();

    OutlinePen m_pen;
    PenValue m_depth{1}, m_fineness{0.5};
    QSpinBox *m_size = nullptr, *m_tolerance = nullptr;
};

}  // namespace wend
