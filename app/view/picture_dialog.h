#pragma once

#include <QDialog>

class QCheckBox;
class QSpinBox;

namespace wend {

/// How large the picture of a view shall be, and whether it has a background.
class PictureDialog : public QDialog {
    Q_OBJECT

  public:
    PictureDialog(const QSize& proposal, QWidget* parent);
    QSize size() const;
    bool isTransparent() const;

  private:
    QSpinBox *m_width, *m_height;
    QCheckBox* m_transparent;
};

}  // namespace wend
