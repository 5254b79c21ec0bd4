#pragma once

#include <QDialog>

#include "warp/vector_drawing.h"

class QSpinBox;

namespace wend {

/// Asks for the size in pixels at which a drawing is drawn; width and height follow each other.
class DrawingSizeDialog : public QDialog {
    Q_OBJECT

  public:
    DrawingSizeDialog(const DrawnSize& now, QWidget* parent);

    DrawnSize size() const;

  private:
    QSpinBox *m_width, *m_height;
};

}  // namespace wend
