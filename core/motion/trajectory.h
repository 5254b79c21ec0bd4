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
template <int Dim>
struct MovingMap {
    AffineMap<Dim> position;
    AffineMap<Dim> velocity;  // the analytic derivative of position: d/dt (A x + b) = velocity(x)
};

/// One motion, ready to evaluate: M(t) with M(start) = identity, for t in [start, end]; the end value after
/// it. Throws InputError for a motion that makes no sense (window reversed, fewer points than the
/// interpolation needs, a zero axis, times that do not increase, a scale ≤ 0, twist in 2D …), naming the key.
template <int Dim>
class Trajectory {
  public:
    explicit Trajectory(const Motion<Dim>& motion);
    ~Trajectory();
    Trajectory(Trajectory&&) noexcept;
    Trajectory& operator=(Trajectory&&) noexcept;

    double start() const;
    double end() const;
    MovingMap<Dim> at(double t) const;
    /// Times inside ]start, end[ where the velocity jumps (corners of polylines and strokes, loose Bézier
    /// joints): an integrator must not step across.
    const std::vector<double>& breakTimes() const;
    /// For drawing: the curve's point γ, its tangent frame F (columns) and parameter at time t. For Translate
    /// and Rotate γ is the displacement's resp. centre's position and F the rotation.
    Vec<Dim> curvePoint(double t) const;
    Mat<Dim> frame(double t) const;

  private:
    struct Path;
    std::unique_ptr<Path> m_path;
};

}  // namespace wend
