#include "app/document/edits/rigid_path.h"

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr int kRigidPoses = 48;       // of a motion, besides those at its corners
constexpr double kRigid = 1e-9;       // how far AᵀA may be from the identity
constexpr double kPosesApart = 1e-3;  // of an even interval: poses that are nearer are left out

/// Rotations only, at all times.
template <int Dim>
bool turnsOnly(const Motion<Dim>& motion) {
    if (std::holds_alternative<FieldMotion<Dim>>(motion.kind)) return false;
    const auto* curve = std::get_if<CurveMotion<Dim>>(&motion.kind);
    return !curve || curve->scale == 1;
}

template <int Dim>
RotationVector<Dim> rotationOf(const Mat<Dim>& A, const RotationVector<Dim>& before) {
    if constexpr (Dim == 2) {
        const double angle = std::atan2(A(1, 0), A(0, 0));
        const double turn = 2 * EIGEN_PI;
        return RotationVector<2>(angle + turn * std::round((before[0] - angle) / turn));
    } else {
        const Eigen::AngleAxisd turn(A);
        return turn.angle() * turn.axis();
    }
}

/// The times of the poses: even ones, and corners, where the velocity jumps.
std::set<double> poseTimes(const MotionTime& part, const std::vector<double>& corners) {
    const double step = (part.end - part.start) / kRigidPoses;
    std::set<double> times = {part.start, part.end};
    const auto add = [&](double t) {
        if (t <= part.start + kPosesApart * step || t >= part.end - kPosesApart * step) return;
        const auto after = times.lower_bound(t);
        if (*after - t > kPosesApart * step && t - *std::prev(after) > kPosesApart * step) times.insert(t);
    };
    for (const double corner : corners) add(corner);
    for (int k = 1; k < kRigidPoses; ++k) add(part.start + k * step);
    return times;
}

}  // namespace

template <int Dim>
std::optional<Motion<Dim>> ledRigidly(const Motion<Dim>& motion, const MotionTime& part,
                                      const Vec<Dim>& place, const Vec<Dim>& by, double first, double last) {
    if (!turnsOnly<Dim>(motion)) return {};
    const Trajectory<Dim> trajectory(motion);
    PoseMotion<Dim> poses;
    poses.hasOwnTimes = true;
    RotationVector<Dim> rotation = RotationVector<Dim>::Zero();
    for (const double time : poseTimes(part, trajectory.breakTimes())) {
        const AffineMap<Dim> map = trajectory.at(time, Side::Before).position;
        if ((map.A.transpose() * map.A - Mat<Dim>::Identity()).norm() > kRigid) return {};
        const double share = (time - part.start) / (part.end - part.start);
        rotation = rotationOf<Dim>(map.A, rotation);
        poses.times.push_back(time);
        poses.poses.push_back({map(place) + std::lerp(first, last, share) * by, rotation});
    }
    return Motion<Dim>{std::move(poses), part.start, part.end};
}

template <int Dim>
std::optional<Vec<Dim>> startOfRigid(const Motion<Dim>& motion, double time, const Vec<Dim>& place) {
    if (!turnsOnly<Dim>(motion)) return {};
    const AffineMap<Dim> map = Trajectory<Dim>(motion).at(time, Side::Before).position;
    return map.A.transpose() * (place - map.b);
}

#define WEND_INSTANTIATE(Dim)                                                                              \
    template std::optional<Motion<Dim>> ledRigidly<Dim>(const Motion<Dim>&, const MotionTime&,             \
                                                        const Vec<Dim>&, const Vec<Dim>&, double, double); \
    template std::optional<Vec<Dim>> startOfRigid<Dim>(const Motion<Dim>&, double, const Vec<Dim>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
