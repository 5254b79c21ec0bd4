#pragma once

#include <QWidget>

#include "app/session/pins.h"
#include "app/session/selection.h"
#include "app/session/shape_motion.h"

class QLabel;

namespace wend {

/// Sizes of a solid and of its selected part, and all values at the place under the pointer.
class MeasurePanel : public QWidget {
    Q_OBJECT

  public:
    MeasurePanel(ShapeMotion& motion, Selection& selection, const ShownPins& pins, QWidget* parent = nullptr);

  public slots:
    /// Sets the cell under the pointer with its nearest corner and the point; cell −1 for none.
    void setPointed(int cell, int vertex, const wend::Vec3& point);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void refresh();
    void showSizes();
    void showPointed();

    ShapeMotion& m_motion;
    Selection& m_selection;
    const ShownPins& m_shown;
    QLabel *m_whole, *m_part, *m_point, *m_cell;
    int m_pointedCell = -1, m_vertex = -1;
    Vec3 m_at = Vec3::Zero();
};

}  // namespace wend
