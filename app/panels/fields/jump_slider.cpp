#include "app/panels/fields/jump_slider.h"

#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionSlider>

namespace wend {

JumpSlider::JumpSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    connect(this, &QSlider::sliderPressed, this, [this] { ++m_gesture; });
    connect(this, &QSlider::valueChanged, this, [this](int value) {
        if (!isSliderDown()) ++m_gesture;
        emit moved(value, m_gesture);
    });
}

QRect JumpSlider::way() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const auto partOf = [&](QStyle::SubControl part) {
        return style()->subControlRect(QStyle::CC_Slider, &option, part, this);
    };
    const int half = partOf(QStyle::SC_SliderHandle).width() / 2;
    return partOf(QStyle::SC_SliderGroove).adjusted(half, 0, -half, 0);
}

/// Emits sliderPressed first, so that a new gesture starts, then moves the handle's centre to the pointer and
/// lets Qt continue as if the handle had been pressed.
void JumpSlider::mousePressEvent(QMouseEvent* event) {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    const QPoint at = event->position().toPoint();
    if (event->button() != Qt::LeftButton || handle.contains(at)) {
        QSlider::mousePressEvent(event);
        return;
    }
    setSliderDown(true);
    setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), at.x() - way().x(), way().width(),
                                             option.upsideDown));
    const QPointF onHandle(event->position().x(), handle.center().y());
    QMouseEvent press(event->type(), onHandle, event->globalPosition(), event->button(), event->buttons(),
                      event->modifiers(), event->pointingDevice());
    QSlider::mousePressEvent(&press);
}

}  // namespace wend
