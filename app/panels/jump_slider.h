#pragma once

#include <QSlider>

namespace wend {

/// A horizontal slider whose handle comes to where it is clicked, and is dragged from there.
class JumpSlider : public QSlider {
  public:
    explicit JumpSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}

  protected:
    void mousePressEvent(QMouseEvent* event) override;
};

}  // namespace wend
