#pragma once

#include <QDialog>

class QCheckBox;
class QSpinBox;

namespace wend {

/// What a picture of a view shall be.
struct PictureChoice {
    QSize size;
    bool transparent = true;
    bool marks = false;   // pins, paths and axes, as they are seen
    bool legend = false;  // of the map, if one is shown
};

/// How large the picture of a view shall be, and what is in it.
class PictureDialog : public QDialog {
    Q_OBJECT

  public:
    PictureDialog(const QSize& proposal, bool hasLegend, QWidget* parent);
    PictureChoice choice() const;

  private:
    QSpinBox *m_width, *m_height;
    QCheckBox *m_transparent, *m_marks, *m_legend;
};

}  // namespace wend
