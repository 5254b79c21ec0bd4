#pragma once

#include <QSlider>

namespace wend {

/// A horizontal slider whose handle jumps to a click and can be dragged from there.
class JumpSlider : public QSlider {
    Q_OBJECT

  public:
    explicit JumpSlider(QWidget* parent = nullptr);
    /// Returns the range of the handle's centre in the slider's coordinates.
    QRect way() const;

  signals:
    /// Emitted with valueChanged(); the number is the same for all values of one gesture of the mouse, and
    /// another one for each step of a key.
    void moved(int value, int gesture);

  protected:
    void mousePressEvent(QMouseEvent* event) override;

  private:
    int m_gesture = 0;
};

}  // namespace wend
