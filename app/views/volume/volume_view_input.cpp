#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "app/views/volume/volume_view.h"

namespace wend {

void VolumeView::mousePressEvent(QMouseEvent* event) {
    m_navigation.press(*event);
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
    m_navigation.move(*event, m_camera, size());
    if (!m_navigation.isGoingOn()) return;
    hurry();
    update();
    emit cameraChanged();
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
    const bool click = m_navigation.isClick(*event);
    const SolidHit hit = click ? pick(event->position()) : SolidHit{};
    const bool pivots = event->button() == Qt::MiddleButton || m_navigation.drag() == Navigation::Drag::Orbit;
    if (click && pivots && event->button() != Qt::LeftButton && hit.cell >= 0) m_camera.setPivot(hit.point);
    m_navigation.end();
    update();
}

void VolumeView::wheelEvent(QWheelEvent* event) {
    m_camera.zoom(std::exp(event->angleDelta().y() / 120.0 * 0.16), pixelOf(event->position()), size());
    hurry();
    update();
    emit cameraChanged();
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
    const bool opposite = event->modifiers() & Qt::ControlModifier;
    using Axis = Camera::Axis;
    switch (event->key()) {
        case Qt::Key_1:
            look(opposite ? Axis::Back : Axis::Front);
            break;
        case Qt::Key_3:
            look(opposite ? Axis::Left : Axis::Right);
            break;
        case Qt::Key_7:
            look(opposite ? Axis::Bottom : Axis::Top);
            break;
        case Qt::Key_5:
            setOrthographic(!m_camera.orthographic());
            break;
        case Qt::Key_0:
            look(Axis::Isometric);
            break;
        case Qt::Key_F:
            fit();
            break;
        default:
            QOpenGLWidget::keyPressEvent(event);
    }
}

}  // namespace wend
