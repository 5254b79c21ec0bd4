#pragma once

#include <QSlider>

namespace wend {

/// A horizontal slider whose handle comes to where it is clicked, and is dragged from there.
class JumpSlider : public QSlider {
  public:
    explicit JumpSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}
    /// Where the middle of its handle is, in its own coordinates: from the smallest value to the largest.
    QRect way() const;

  protected:
    void mousePressEvent(QMouseEvent* event) override;
};

}  // namespace wend
