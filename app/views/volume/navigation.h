#pragma once

#include <QMouseEvent>

#include "app/views/volume/camera.h"

namespace wend {

/// Mouse buttons for navigation. Wend: right or middle rotates, with Shift pans, with Ctrl zooms. VTK-like:
/// left rotates, middle pans, right zooms. Blender-like: middle rotates, with Shift pans, with Ctrl zooms.
enum class NavigationPreset { Wend, VtkLike, BlenderLike };

/// Rotates, pans and zooms a camera by mouse, whatever is under it.
class Navigation {
  public:
    enum class Drag { None, Orbit, Pan, Zoom };

    void setPreset(NavigationPreset preset) { m_preset = preset; }
    /// Returns the drag that a press of this button would start.
    Drag dragFor(const QMouseEvent& event) const;
    Drag drag() const { return m_drag; }
    bool isGoingOn() const { return m_drag != Drag::None; }
    /// Returns whether the pointer is where it was pressed.
    bool isClick(const QMouseEvent& event) const;

    void press(const QMouseEvent& event);
    /// Starts panning, whatever the button means.
    void pressToPan(const QMouseEvent& event);
    void move(const QMouseEvent& event, Camera& camera, const QSize& view);
    void end() { m_drag = Drag::None; }

  private:
    NavigationPreset m_preset = NavigationPreset::Wend;
    Drag m_drag = Drag::None;
    QPointF m_last, m_pressed;
};

}  // namespace wend
