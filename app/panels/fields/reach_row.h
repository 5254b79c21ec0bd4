#pragma once

#include <QWidget>

#include "app/document/edits/document.h"

namespace wend {

class JumpSlider;

/// How far a pull reaches, from near to far: the smoothing length for those who want no number. Evenly in
/// its logarithm; lengths beyond the slider's ends stand at the ends, and stay as they are until it is moved.
class ReachRow : public QWidget {
    Q_OBJECT

  public:
    explicit ReachRow(Document& document, QWidget* parent = nullptr);

  private:
    void showProject();

    Document& m_document;
    JumpSlider* m_slider;
    int m_gesture = 0;
};

}  // namespace wend
