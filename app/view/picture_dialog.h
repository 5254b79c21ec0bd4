#pragma once

#include <QDialog>

class QCheckBox;
class QDialogButtonBox;
class QLabel;
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
    void tie(QSpinBox* changed);
    void check();

    QSize m_proportions;  // of the view
    QSpinBox *m_width, *m_height;
    QCheckBox* m_tied;  // width and height, as in the view
    QLabel* m_note;     // why it cannot be written
    QDialogButtonBox* m_buttons;
    QCheckBox *m_transparent, *m_marks, *m_legend;
};

}  // namespace wend
