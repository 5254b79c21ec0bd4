#include "core/motion/screw_motion.h"

#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace wend {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kParallel = 1e-12;   // sine of the angle between two rotation vectors
constexpr double kWholeTurn = 1e-7;   // |sinc(θ/2)| below which a turn is a whole one
constexpr double kAlongAxis = 1e-12;  // relative to the shift

double sinc(double x) {
    return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x;
}

/// Returns ω × v.
Vec2 cross(const RotationVector<2>& w, const Vec2& v) {
    return w[0] * Vec2(-v[1], v[0]);
}
Vec3 cross(const RotationVector<3>& w, const Vec3& v) {
    return w.cross(v);
}

/// Returns the part of v along the axis ω; zero in the plane.
Vec2 along(const RotationVector<2>&, const Vec2&) {
    return Vec2::Zero();
}
Vec3 along(const RotationVector<3>& w, const Vec3& v) {
    const double square = w.squaredNorm();
    return square > 0 ? Vec3(w * (w.dot(v) / square)) : v;
}

Eigen::Quaterniond quaternionOf(const RotationVector<3>& w) {
    const double angle = w.norm();
    Eigen::Quaterniond q;
    q.w() = std::cos(angle / 2);
    q.vec() = w * (0.5 * sinc(angle / 2));
    return q;
}

}  // namespace

RotationVector<2> turnBetween(const RotationVector<2>& from, const RotationVector<2>& to) {
    return to - from;
}
RotationVector<3> turnBetween(const RotationVector<3>& from, const RotationVector<3>& to) {
    const bool isLong = std::max(from.norm(), to.norm()) > kPi * (1 + 1e-9);
    if (isLong && from.cross(to).norm() <= kParallel * from.norm() * to.norm()) return to - from;
    Eigen::Quaterniond q = quaternionOf(to) * quaternionOf(from).conjugate();
    if (q.w() < 0) q.coeffs() *= -1;
    const double half = q.vec().norm();
    return half > 0 ? RotationVector<3>(q.vec() * (2 * std::atan2(half, q.w()) / half))
                    : RotationVector<3>::Zero();
}

template <>
Mat2 rotationOf<2>(const RotationVector<2>& vector) {
    return Eigen::Rotation2Dd(vector[0]).toRotationMatrix();
}
template <>
Mat3 rotationOf<3>(const RotationVector<3>& vector) {
    return quaternionOf(vector).toRotationMatrix();
}

/// Computes v = V(1)⁻¹ d for the shift d: along the axis d itself; across it, with a = sinc θ, b = sinc²(θ/2)
/// / 2 and a² + (b θ)² = sinc²(θ/2), (a d − b ω × d) / sinc²(θ/2).
template <int Dim>
ScrewMotion<Dim>::ScrewMotion(const RigidPose<Dim>& from, const RigidPose<Dim>& to)
    : m_pivot(from.position), m_turn(turnBetween(from.rotation, to.rotation)) {
    const Vec<Dim> shift = to.position - from.position;
    m_rate = along(m_turn, shift);
    const Vec<Dim> across = shift - m_rate;
    if (m_turn.norm() == 0) {
        m_rate = shift;
        return;
    }
    const double half = sinc(m_turn.norm() / 2);
    if (std::abs(half) > kWholeTurn)
        m_rate += (sinc(m_turn.norm()) * across - 0.5 * half * half * cross(m_turn, across)) / (half * half);
    else if (across.norm() > kAlongAxis * (shift.norm() + from.position.norm() + to.position.norm()))
        throw InputError("a whole turn cannot be a screw motion with a shift across its axis");
}

/// Returns V(s) v: s along the axis; across it s sinc(θs) v + (s²/2) sinc²(θs/2) ω × v.
template <int Dim>
Vec<Dim> ScrewMotion<Dim>::travelled(double s) const {
    const double angle = s * m_turn.norm(), half = sinc(angle / 2);
    const Vec<Dim> axial = m_turn.norm() > 0 ? along(m_turn, m_rate) : m_rate;
    const Vec<Dim> across = m_rate - axial;
    return s * axial + s * sinc(angle) * across + 0.5 * s * s * half * half * cross(m_turn, across);
}

template <int Dim>
MovingMap<Dim> ScrewMotion<Dim>::at(double s) const {
    MovingMap<Dim> map;
    const Mat<Dim> A = rotationOf<Dim>(s * m_turn);
    map.position = {A, m_pivot + travelled(s) - A * m_pivot};
    for (int k = 0; k < Dim; ++k) map.velocity.A.col(k) = cross(m_turn, Vec<Dim>(A.col(k)));
    map.velocity.b = A * m_rate - map.velocity.A * m_pivot;
    return map;
}

RotationVector<3> rotationVectorOf(const Eigen::Quaterniond& rotation, const RotationVector<3>& before) {
    Eigen::Quaterniond q = rotation.normalized();
    if (q.w() < 0) q.coeffs() *= -1;
    const double sine = q.vec().norm();
    if (sine == 0) return RotationVector<3>::Zero();
    const RotationVector<3> axis = q.vec() / sine;
    const double angle = 2 * std::atan2(sine, q.w());
    return axis * (angle + 2 * kPi * std::round((axis.dot(before) - angle) / (2 * kPi)));
}

template <int Dim>
RigidPose<Dim> poseBetween(const RigidPose<Dim>& from, const RigidPose<Dim>& to, double s) {
    const Vec<Dim> position = ScrewMotion<Dim>(from, to).at(s).position(from.position);
    const RotationVector<Dim> turn = turnBetween(from.rotation, to.rotation);
    if constexpr (Dim == 2)
        return {position, from.rotation + s * turn};
    else
        return {position,
                rotationVectorOf(quaternionOf(s * turn) * quaternionOf(from.rotation), from.rotation)};
}

template RigidPose<2> poseBetween(const RigidPose<2>&, const RigidPose<2>&, double);
template RigidPose<3> poseBetween(const RigidPose<3>&, const RigidPose<3>&, double);
template class ScrewMotion<2>;
template class ScrewMotion<3>;

}  // namespace wend
