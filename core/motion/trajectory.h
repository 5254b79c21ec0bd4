#pragma once

#include <memory>

#include "core/motion/handle.h"

namespace wend {

/// x ↦ A x + b with its derivative in time: where the points of a handle are, from where they were at the
/// window's start.
template <int Dim>
struct AffineMap {
    Mat<Dim> A = Mat<Dim>::Identity();
    Vec<Dim> b = Vec<Dim>::Zero();

    Vec<Dim> operator()(const Vec<Dim>& x) const { return A * x + b; }
};
/// The map of a handle's points at a time, and its derivative.
template <int Dim>
struct MovingMap {
    AffineMap<Dim> position;
    AffineMap<Dim> velocity;  // the analytic derivative of position: d/dt (A x + b) = velocity(x)
    /// The part of its own displacement that each point has made in addition (FieldMotion), and its d/dt.
    double share = 0, shareRate = 0;
};

/// The side of a time at which the velocity jumps: the interval that ends there, or the one that begins.
enum class Side { Before, After };

/// Evaluates one motion: M(t) with M(start) = identity, for t in [start, end]; the end value afterwards. A
/// curve moves x to γ + s Q (x − γ(0)), with the rotation Q of its frame including the twist, and the scale
/// s, both linear in the curve's parameter. The times of a stroke and of poses are mapped linearly to the
/// interval. Throws InputError for an invalid motion (reversed interval, fewer points than the interpolation
/// needs, a zero axis, times that do not increase, a scale ≤ 0, twist in 2D …), naming the key.
template <int Dim>
class Trajectory {
  public:
    explicit Trajectory(const Motion<Dim>& motion);
    ~Trajectory();
    Trajectory(Trajectory&&) noexcept;
    Trajectory& operator=(Trajectory&&) noexcept;

    double start() const;
    double end() const;
    /// Returns M(t) and its derivative. The side matters at break times only; outside [start, end] the
    /// position is constant.
    MovingMap<Dim> at(double t, Side side = Side::After) const;
    /// Returns the times inside ]start, end[ where the velocity jumps (corners of polylines and strokes,
    /// loose Bézier joints), which no step of an integrator may cross.
    const std::vector<double>& breakTimes() const;
    /// Return, for drawing, the curve's point γ and its frame F (columns: tangent, normal …, twisted; the
    /// axes if no frame is used) at time t. For Translate and Rotate γ is the displacement or the centre, for
    /// a FieldMotion the mean displacement, for poses the origin of the body, and F the rotation.
    Vec<Dim> curvePoint(double t) const;
    Mat<Dim> frame(double t) const;

  private:
    struct Path;
    std::unique_ptr<Path> m_path;
};

}  // namespace wend
