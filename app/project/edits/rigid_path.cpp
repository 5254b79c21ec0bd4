#include "app/project/edits/rigid_path.h"

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "core/motion/screw_motion.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr int kRigidPoses = 48;       // of a motion, besides those at its corners
constexpr double kRigid = 1e-9;       // how far AᵀA may be from the identity
constexpr double kSameAxis = 1e-6;    // cosines of two axes that are one differ from ±1 by less
constexpr double kWholeTurn = 1e-6;   // sine of half the angle, below which it is a whole turn
constexpr double kLeastTurn = 1e-3;   // radians: a rotation by less has its centre too far away
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

/// A rigid motion from its start to its end.
template <int Dim>
struct Turn {
    Vec<Dim> axis = Vec<Dim>::Zero();  // in space: of length 1
    double angle = 0;                  // in whole
    AffineMap<Dim> map;
};

Mat<2> quarterTurn(const Vec<2>&) {
    return Mat<2>{{0, -1}, {1, 0}};
}
Mat<3> quarterTurn(const Vec<3>& axis) {
    Mat<3> cross;
    cross << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
    return cross;
}

/// Returns the whole turn of a table of poses; nothing if its axis changes.
template <int Dim>
std::optional<Turn<Dim>> turnOf(const PoseMotion<Dim>& poses, const AffineMap<Dim>& map) {
    Turn<Dim> turn{Vec<Dim>::Zero(), 0, map};
    if constexpr (Dim == 2) {
        turn.angle = poses.poses.back().rotation[0] - poses.poses.front().rotation[0];
    } else {
        for (std::size_t k = 1; k < poses.poses.size(); ++k) {
            const Eigen::AngleAxisd step(
                Mat<3>(wend::rotationOf<3>(poses.poses[k].rotation) *
                       wend::rotationOf<3>(poses.poses[k - 1].rotation).transpose()));
            if (step.angle() < kRigid) continue;
            if (turn.axis.isZero(0)) turn.axis = step.axis();
            const double along = step.axis().dot(turn.axis);
            if (std::abs(std::abs(along) - 1) > kSameAxis) return {};
            turn.angle += along > 0 ? step.angle() : -step.angle();
        }
    }
    return turn;
}

template <int Dim>
std::optional<Turn<Dim>> turnOf(const Motion<Dim>& motion) {
    const AffineMap<Dim> map = Trajectory<Dim>(motion).at(motion.end, Side::Before).position;
    if (const auto* poses = std::get_if<PoseMotion<Dim>>(&motion.kind)) return turnOf<Dim>(*poses, map);
    if (std::holds_alternative<Translate<Dim>>(motion.kind)) return Turn<Dim>{Vec<Dim>::Zero(), 0, map};
    const auto* rotate = std::get_if<Rotate<Dim>>(&motion.kind);
    if (!rotate) return {};
    return Turn<Dim>{Dim == 3 ? Vec<Dim>(rotate->axis.normalized()) : Vec<Dim>(Vec<Dim>::Zero()),
                     rotate->angle, map};
}

/// Returns the motion of constant twist that does a turn: a rotation about x = ½ (b + cot(θ/2) J b), where b
/// is the shift across the axis and J a quarter turn, unless the shift has a part along the axis.
template <int Dim>
std::optional<Motion<Dim>> motionOf(const Turn<Dim>& turn, const Vec<Dim>& origin) {
    if (std::abs(turn.angle) < kRigid) return Motion<Dim>{Translate<Dim>{turn.map(origin) - origin}};
    const double along = turn.axis.dot(turn.map.b), size = turn.map.b.norm();
    const Vec<Dim> across = turn.map.b - along * turn.axis;
    const double half = std::sin(turn.angle / 2);
    if (std::abs(half) < kWholeTurn) return {};
    if (std::abs(along) <= kRigid * size) {
        const Mat<Dim> J = quarterTurn(turn.axis);
        const Vec<Dim> centre = 0.5 * (across + std::cos(turn.angle / 2) / half * (J * across));
        return Motion<Dim>{Rotate<Dim>{centre, turn.axis, turn.angle}};
    }
    PoseMotion<Dim> poses;
    poses.times = {0, 1};
    poses.poses = {{origin, RotationVector<Dim>::Zero()}, {turn.map(origin), RotationVector<Dim>::Zero()}};
    if constexpr (Dim == 3) poses.poses[1].rotation = turn.angle * turn.axis;
    return Motion<Dim>{std::move(poses)};
}

template <int Dim>
Vec<Dim> originOf(const Motion<Dim>& motion) {
    if (const auto* poses = std::get_if<PoseMotion<Dim>>(&motion.kind)) return poses->poses.front().position;
    if (const auto* rotate = std::get_if<Rotate<Dim>>(&motion.kind)) return rotate->centre;
    return Vec<Dim>::Zero();
}

}  // namespace

template <int Dim>
std::optional<Motion<Dim>> turnedTo(const Motion<Dim>& motion, const Vec<Dim>& first, const Vec<Dim>& last) {
    const auto* rotate = std::get_if<Rotate<Dim>>(&motion.kind);
    if (!rotate || std::abs(rotate->angle) > EIGEN_PI || std::abs(rotate->angle) < kLeastTurn) return {};
    Turn<Dim> turn = *turnOf<Dim>(motion);
    turn.map.b += last - turn.map.A * first;
    auto result = motionOf<Dim>(turn, rotate->centre);
    if (!result) return {};
    result->start = motion.start;
    result->end = motion.end;
    result->ease = motion.ease;
    return result;
}

template <int Dim>
std::vector<Motion<Dim>> ledRotation(const Motion<Dim>& motion, const Vec<Dim>& by, double time) {
    const auto* rotate = std::get_if<Rotate<Dim>>(&motion.kind);
    if (!rotate || motion.ease != Ease::Linear) return {};
    const double share = (time - motion.start) / (motion.end - motion.start);
    const auto part = [&](double angle, double start, double end) {
        Rotate<Dim> own = *rotate;
        own.angle = angle;
        return Motion<Dim>{own, start, end};
    };
    const auto before = turnedTo<Dim>(part(share * rotate->angle, motion.start, time), Vec<Dim>::Zero(), by),
               after =
                   turnedTo<Dim>(part((1 - share) * rotate->angle, time, motion.end), by, Vec<Dim>::Zero());
    if (!before || !after) return {};
    return {*before, *after};
}

template <int Dim>
std::optional<Motion<Dim>> joinedRotations(const Motion<Dim>& before, const Motion<Dim>& after) {
    const auto one = turnOf<Dim>(before), two = turnOf<Dim>(after);
    if (!one || !two) return {};
    Turn<Dim> whole{
        one->axis, one->angle + two->angle, {two->map.A * one->map.A, two->map.A * one->map.b + two->map.b}};
    if constexpr (Dim == 3) {
        const double along = one->axis.dot(two->axis);
        if (one->axis.isZero(0)) {
            whole.axis = two->axis;
        } else if (!two->axis.isZero(0) && std::abs(std::abs(along) - 1) > kSameAxis) {
            const Eigen::AngleAxisd shortest(whole.map.A);
            whole.axis = shortest.axis();
            whole.angle = shortest.angle();
        } else if (along < 0) {
            whole.angle = one->angle - two->angle;
        }
    }
    const bool isPoses = std::holds_alternative<PoseMotion<Dim>>(before.kind);
    auto result = motionOf<Dim>(whole, originOf<Dim>(isPoses ? before : after));
    if (!result) return {};
    result->start = before.start;
    result->end = after.end;
    return result;
}

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

#define WEND_INSTANTIATE(Dim)                                                                                \
    template std::optional<Motion<Dim>> turnedTo<Dim>(const Motion<Dim>&, const Vec<Dim>&, const Vec<Dim>&); \
    template std::vector<Motion<Dim>> ledRotation<Dim>(const Motion<Dim>&, const Vec<Dim>&, double);         \
    template std::optional<Motion<Dim>> joinedRotations<Dim>(const Motion<Dim>&, const Motion<Dim>&);        \
    template std::optional<Motion<Dim>> ledRigidly<Dim>(const Motion<Dim>&, const MotionTime&,               \
                                                        const Vec<Dim>&, const Vec<Dim>&, double, double);   \
    template std::optional<Vec<Dim>> startOfRigid<Dim>(const Motion<Dim>&, double, const Vec<Dim>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
