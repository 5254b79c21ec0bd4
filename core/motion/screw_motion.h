#pragma once

#include <Eigen/Geometry>

#include "core/motion/trajectory.h"

namespace wend {

/// Returns the rotation matrix of a rotation vector. The vector is in radians; 0 gives the identity.
template <int Dim>
Mat<Dim> rotationOf(const RotationVector<Dim>& vector);

/// Returns the turn ω of the motion between two poses, see ScrewMotion.
RotationVector<2> turnBetween(const RotationVector<2>& from, const RotationVector<2>& to);
RotationVector<3> turnBetween(const RotationVector<3>& from, const RotationVector<3>& to);

/// The motion of constant twist between two poses of a body: for s in [0, 1]
///   S(s): y ↦ A(s) (y − p) + p + V(s) v,  A(s) = exp(s [ω]×),  V(s) = ∫₀ˢ exp(τ [ω]×) dτ,
/// with p the first position. ω and v follow from S(1) taking the first pose to the second, which is so to
/// rounding. In space ω is the shortest turn; where both rotation vectors have one direction and one of them
/// is longer than π, their difference, so that whole turns can be given. In the plane it is always the
/// difference of the angles.
template <int Dim>
class ScrewMotion {
  public:
    /// Throws InputError where a whole turn and a shift across its axis have no constant twist.
    ScrewMotion(const RigidPose<Dim>& from, const RigidPose<Dim>& to);

    /// Returns S(s) with its derivative in s.
    MovingMap<Dim> at(double s) const;

  private:
    Vec<Dim> travelled(double s) const;

    Vec<Dim> m_pivot, m_rate;  // p, v
    RotationVector<Dim> m_turn;
};

/// Returns S(s) of the first pose, with the rotation vector in the turn that continues that of the first.
/// Throws InputError as ScrewMotion does.
template <int Dim>
RigidPose<Dim> poseBetween(const RigidPose<Dim>& from, const RigidPose<Dim>& to, double s);

/// Returns the rotation vector of a quaternion, in the turn that is nearest to the rotation `before`. The
/// quaternion need not have length 1. Without a rotation the result is 0, whatever `before` is.
RotationVector<3> rotationVectorOf(const Eigen::Quaterniond& rotation, const RotationVector<3>& before);

}  // namespace wend
