#pragma once

#include <Eigen/Geometry>
#include <QMouseEvent>
#include <QSize>

#include "app/project/solid_view.h"
#include "app/tools/solid_shape_view.h"

namespace wend {

/// Looks at a pivot from a distance; y of the screen is up. All angles in radians, all pixels from the top
/// left corner.
class Camera {
  public:
    enum class Axis { Front, Back, Left, Right, Top, Bottom, Isometric };

    /// Shows the box that spans low … high whole, the pivot in its middle.
    void fit(const Vec3& low, const Vec3& high);
    /// Shows all points as large as they fit, from where it looks.
    void fit(const Points3& points, const QSize& viewport);
    void look(Axis axis);
    /// Sets the world axis that points up, which rotation keeps upright.
    void setUpAxis(UpAxis axis);
    UpAxis upAxis() const { return m_upAxis; }
    /// Returns the camera for storage, with as many digits as a screen can show.
    SavedCamera saved() const;
    /// Restores a stored camera.
    void restore(const SavedCamera& kept);
    /// Changes the centre of rotation without moving the picture.
    void setPivot(const Vec3& pivot);
    /// Centres a point and makes it the centre of rotation.
    void lookAt(const Vec3& point);
    /// Looks along a direction.
    void lookAlong(const Vec3& direction);
    void setOrthographic(bool on) { m_orthographic = on; }
    bool orthographic() const { return m_orthographic; }
    const Vec3& pivot() const { return m_pivot; }

    /// Turns around the pivot as a turntable: dx around the world's vertical axis, dy around the screen's
    /// horizontal one.
    void orbit(double dx, double dy);
    /// Moves the view so that the point under the pointer at the pivot's depth follows it.
    void pan(double dxPixels, double dyPixels, const QSize& viewport);
    /// Zooms in for factors > 1 around the pixel at the pivot's depth.
    void zoom(double factor, const Eigen::Vector2d& pixel, const QSize& viewport);

    Eigen::Matrix4d view() const;
    Eigen::Matrix4d projection(const QSize& viewport) const;
    Ray ray(const Eigen::Vector2d& pixel, const QSize& viewport) const;
    /// Returns the pixel and the depth in [−1, 1] of a point.
    Vec3 project(const Vec3& p, const QSize& viewport) const;
    Vec3 direction() const { return m_turn.conjugate() * Vec3(0, 0, -1); }
    Vec3 up() const { return m_turn.conjugate() * Vec3::UnitY(); }
    Vec3 right() const { return m_turn.conjugate() * Vec3::UnitX(); }
    /// Return the length in the world of a pixel at the pivot's depth, and at a point.
    double pixelSize(const QSize& viewport) const;
    double pixelSize(const QSize& viewport, const Vec3& at) const;

  private:
    Eigen::Quaterniond m_turn = Eigen::Quaterniond::Identity();  // world → camera
    /// Returns the point in the middle of the picture at the pivot's depth.
    Vec3 centre() const;
    /// Returns the world's axes to the right, into the picture and upwards, seen from the front.
    Mat3 axes() const;

    Vec3 m_pivot = Vec3::Zero();
    Eigen::Vector2d m_shift = Eigen::Vector2d::Zero();  // of the pivot from the middle, to the right and up
    double m_distance = 3;
    double m_radius = 1;  // of the scene, for the clip planes
    bool m_orthographic = false;
    UpAxis m_upAxis = UpAxis::Z;
};

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
