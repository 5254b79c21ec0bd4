#pragma once

#include <QSlider>

namespace wend {

/// A horizontal slider whose handle jumps to a click and can be dragged from there.
class JumpSlider : public QSlider {
  public:
    explicit JumpSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}
    /// Returns the range of the handle's centre in the slider's coordinates.
    QRect way() const;

  protected:
    void mousePressEvent(QMouseEvent* event) override;
};

}  // namespace wend
