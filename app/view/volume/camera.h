#pragma once

#include <Eigen/Geometry>
#include <QSize>

#include "core/mesh/types.h"

namespace wend {

struct Ray {
    Vec<3> origin, direction;  // direction has length 1
};

/// Looks at a pivot from a distance; y of the screen is up. All angles in radians, all pixels from the top
/// left corner.
class Camera {
  public:
    enum class Axis { Front, Back, Left, Right, Top, Bottom, Isometric };

    /// Shows the box that spans low … high whole, the pivot in its middle.
    void fit(const Vec<3>& low, const Vec<3>& high);
    void look(Axis axis);
    void setPivot(const Vec<3>& pivot);
    void setOrthographic(bool on) { m_orthographic = on; }
    bool orthographic() const { return m_orthographic; }
    const Vec<3>& pivot() const { return m_pivot; }

    /// Turns around the pivot as a turntable: dx around the world's vertical axis, dy around the screen's
    /// horizontal one.
    void orbit(double dx, double dy);
    /// Moves with the pointer: what lay under it at the pivot's depth stays under it.
    void pan(double dxPixels, double dyPixels, const QSize& viewport);
    /// Factor > 1 comes nearer; what is under the pixel at the pivot's depth stays there.
    void zoom(double factor, const Eigen::Vector2d& pixel, const QSize& viewport);

    Eigen::Matrix4d view() const;
    Eigen::Matrix4d projection(const QSize& viewport) const;
    Ray ray(const Eigen::Vector2d& pixel, const QSize& viewport) const;
    /// Pixel and depth in [−1, 1] of a point.
    Vec<3> project(const Vec<3>& p, const QSize& viewport) const;
    Vec<3> direction() const { return m_turn.conjugate() * Vec<3>(0, 0, -1); }
    Vec<3> up() const { return m_turn.conjugate() * Vec<3>::UnitY(); }
    Vec<3> right() const { return m_turn.conjugate() * Vec<3>::UnitX(); }
    /// World length of a pixel at the pivot's depth.
    double pixelSize(const QSize& viewport) const;

  private:
    Eigen::Quaterniond m_turn = Eigen::Quaterniond::Identity();  // world → camera
    Vec<3> m_pivot = Vec<3>::Zero();
    double m_distance = 3;
    double m_radius = 1;  // of the scene, for the clip planes
    bool m_orthographic = false;
};

}  // namespace wend
