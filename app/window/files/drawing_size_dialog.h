#pragma once

#include <QDialog>

#include "warp/vector_drawing.h"

class QDoubleSpinBox;
class QSpinBox;

namespace wend {

/// Asks for the size at which a drawing is drawn, in pixels or in percent of that at which it is opened:
/// width, height and percent follow each other.
class DrawingSizeDialog : public QDialog {
    Q_OBJECT

  public:
    DrawingSizeDialog(const DrawnSize& now, const DrawnSize& first, QWidget* parent);

    DrawnSize size() const;

  private:
    void tie(QSpinBox* side, QSpinBox* other, double proportion);
    void takePercent(double percent);

    const DrawnSize m_first;
    QSpinBox *m_width, *m_height;
    QDoubleSpinBox* m_percent;
};

}  // namespace wend
