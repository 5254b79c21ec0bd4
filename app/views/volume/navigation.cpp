#include "app/views/volume/navigation.h"

#include <cmath>

namespace wend {

namespace {

constexpr double kRadiansPerPixel = 0.008;
constexpr double kClickPixels = 4;

}  // namespace

Navigation::Drag Navigation::dragFor(const QMouseEvent& event) const {
    const bool shift = event.modifiers() & Qt::ShiftModifier,
               control = event.modifiers() & Qt::ControlModifier, alt = event.modifiers() & Qt::AltModifier;
    const auto button = event.button();
    if (m_preset == NavigationPreset::VtkLike) {
        if (button == Qt::LeftButton) return shift ? Drag::Pan : Drag::Orbit;
        if (button == Qt::MiddleButton) return Drag::Pan;
        return button == Qt::RightButton ? Drag::Zoom : Drag::None;
    }
    const bool right = m_preset == NavigationPreset::Wend && button == Qt::RightButton;
    // Alt with the left button replaces a missing middle button.
    if (button != Qt::MiddleButton && !right && !(alt && button == Qt::LeftButton)) return Drag::None;
    if (shift) return Drag::Pan;
    return control ? Drag::Zoom : Drag::Orbit;
}

bool Navigation::isClick(const QMouseEvent& event) const {
    return (event.position() - m_pressed).manhattanLength() <= kClickPixels;
}

void Navigation::press(const QMouseEvent& event) {
    m_last = m_pressed = event.position();
    m_drag = dragFor(event);
}

void Navigation::pressToPan(const QMouseEvent& event) {
    press(event);
    m_drag = Drag::Pan;
}

void Navigation::move(const QMouseEvent& event, Camera& camera, const QSize& view) {
    const QPointF step = event.position() - std::exchange(m_last, event.position());
    if (m_drag == Drag::Orbit) camera.orbit(step.x() * kRadiansPerPixel, step.y() * kRadiansPerPixel);
    if (m_drag == Drag::Pan) camera.pan(step.x(), step.y(), view);
    if (m_drag == Drag::Zoom)
        camera.zoom(std::exp(-0.01 * step.y()), {view.width() / 2.0, view.height() / 2.0}, view);
}

}  // namespace wend
