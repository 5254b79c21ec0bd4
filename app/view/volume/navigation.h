#pragma once

#include <QMouseEvent>

#include "app/view/volume/camera.h"

namespace wend {

/// Which buttons turn, move and zoom. Wend: right or middle turns, with Shift moves, with Ctrl zooms.
/// VTK-like: left turns, middle moves, right zooms. Blender-like: middle turns, with Shift moves, with Ctrl
/// zooms.
enum class NavigationPreset { Wend, VtkLike, BlenderLike };

/// Turns, moves and zooms a camera with the mouse, whatever is under it.
class Navigation {
  public:
    enum class Drag { None, Orbit, Pan, Zoom };

    void setPreset(NavigationPreset preset) { m_preset = preset; }
    /// What a press of this button would begin.
    Drag dragFor(const QMouseEvent& event) const;
    Drag drag() const { return m_drag; }
    bool isGoingOn() const { return m_drag != Drag::None; }
    /// True if the pointer is where it was pressed.
    bool isClick(const QMouseEvent& event) const;

    void press(const QMouseEvent& event);
    /// Moves the view, whatever the button means.
    void pressToPan(const QMouseEvent& event);
    void move(const QMouseEvent& event, Camera& camera, const QSize& view);
    void end() { m_drag = Drag::None; }

  private:
    NavigationPreset m_preset = NavigationPreset::Wend;
    Drag m_drag = Drag::None;
    QPointF m_last, m_pressed;
};

}  // namespace wend
