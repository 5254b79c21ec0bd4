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
bool turnsOnly(const PinMotion& motion) {
    if (std::holds_alternative<FieldMotion<3>>(motion.kind)) return false;
    const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
    return !curve || curve->scale == 1;
}

/// Returns the vector of a rotation that is nearest to another one along its axis.
RotationVector<3> rotationOf(const Mat3& A, const RotationVector<3>& before) {
    if (A(0, 2) != 0 || A(1, 2) != 0) return rotationVectorOf(Eigen::Quaterniond(A), before);
    const double angle = std::atan2(A(1, 0), A(0, 0)), turn = 2 * EIGEN_PI;  // about z
    return {0, 0, angle + turn * std::round((before.z() - angle) / turn)};
}

/// Returns the times of the poses: evenly spaced ones, and corners, where the velocity jumps.
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
struct Turn {
    Vec3 axis = Vec3::Zero();  // of length 1; zero without a rotation
    double angle = 0;          // in whole
    AffineMap<3> map;
};

Mat3 quarterTurn(const Vec3& axis) {
    Mat3 cross;
    cross << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
    return cross;
}

/// Returns the whole turn of a table of poses; nothing if its axis changes.
std::optional<Turn> turnOf(const PoseMotion<3>& poses, const AffineMap<3>& map) {
    Turn turn{Vec3::Zero(), 0, map};
    for (std::size_t k = 1; k < poses.poses.size(); ++k) {
        const Vec3 step = turnBetween(poses.poses[k - 1].rotation, poses.poses[k].rotation);
        const double angle = step.norm();
        if (angle < kRigid) continue;
        if (turn.axis.isZero(0)) turn.axis = step / angle;
        const double along = step.dot(turn.axis) / angle;
        if (std::abs(std::abs(along) - 1) > kSameAxis) return {};
        turn.angle += along > 0 ? angle : -angle;
    }
    return turn;
}

std::optional<Turn> turnOf(const PinMotion& motion) {
    const AffineMap<3> map = Trajectory<3>(motion).at(motion.end, Side::Before).position;
    if (const auto* poses = std::get_if<PoseMotion<3>>(&motion.kind)) return turnOf(*poses, map);
    if (std::holds_alternative<Translate<3>>(motion.kind)) return Turn{Vec3::Zero(), 0, map};
    const auto* rotate = std::get_if<Rotate<3>>(&motion.kind);
    if (!rotate) return {};
    return Turn{rotate->axis.normalized(), rotate->angle, map};
}

/// Returns the motion of constant twist that does a turn: a rotation about x = ½ (b + cot(θ/2) J b), where b
/// is the shift across the axis and J a quarter turn, unless the shift has a part along the axis.
std::optional<PinMotion> motionOf(const Turn& turn, const Vec3& origin) {
    if (std::abs(turn.angle) < kRigid) return PinMotion{Translate<3>{turn.map(origin) - origin}};
    const double along = turn.axis.dot(turn.map.b), size = turn.map.b.norm();
    const Vec3 across = turn.map.b - along * turn.axis;
    const double half = std::sin(turn.angle / 2);
    if (std::abs(half) < kWholeTurn) return {};
    if (std::abs(along) <= kRigid * size) {
        const Mat3 J = quarterTurn(turn.axis);
        const Vec3 centre = 0.5 * (across + std::cos(turn.angle / 2) / half * (J * across));
        const bool isDown = turn.axis.x() == 0 && turn.axis.y() == 0 && turn.axis.z() < 0;
        return PinMotion{isDown ? Rotate<3>{centre, -turn.axis, -turn.angle}  // as in pictures
                                : Rotate<3>{centre, turn.axis, turn.angle}};
    }
    PoseMotion<3> poses;
    poses.times = {0, 1};
    poses.poses = {{origin, RotationVector<3>::Zero()}, {turn.map(origin), RotationVector<3>::Zero()}};
    poses.poses[1].rotation = turn.angle * turn.axis;
    return PinMotion{std::move(poses)};
}

Vec3 originOf(const PinMotion& motion) {
    if (const auto* poses = std::get_if<PoseMotion<3>>(&motion.kind)) return poses->poses.front().position;
    if (const auto* rotate = std::get_if<Rotate<3>>(&motion.kind)) return rotate->centre;
    return Vec3::Zero();
}

}  // namespace

std::optional<PinMotion> turnedTo(const PinMotion& motion, const Vec3& first, const Vec3& last) {
    const auto* rotate = std::get_if<Rotate<3>>(&motion.kind);
    if (!rotate || std::abs(rotate->angle) > EIGEN_PI || std::abs(rotate->angle) < kLeastTurn) return {};
    Turn turn = *turnOf(motion);
    turn.map.b += last - turn.map.A * first;
    auto result = motionOf(turn, rotate->centre);
    if (!result) return {};
    result->start = motion.start;
    result->end = motion.end;
    result->ease = motion.ease;
    return result;
}

std::vector<PinMotion> ledRotation(const PinMotion& motion, const Vec3& by, double time) {
    const auto* rotate = std::get_if<Rotate<3>>(&motion.kind);
    if (!rotate || motion.ease != Ease::Linear) return {};
    const double share = (time - motion.start) / (motion.end - motion.start);
    const auto part = [&](double angle, double start, double end) {
        Rotate<3> own = *rotate;
        own.angle = angle;
        return PinMotion{own, start, end};
    };
    const auto before = turnedTo(part(share * rotate->angle, motion.start, time), Vec3::Zero(), by),
               after = turnedTo(part((1 - share) * rotate->angle, time, motion.end), by, Vec3::Zero());
    if (!before || !after) return {};
    return {*before, *after};
}

std::optional<PinMotion> joinedRotations(const PinMotion& before, const PinMotion& after) {
    const auto one = turnOf(before), two = turnOf(after);
    if (!one || !two) return {};
    Turn whole{
        one->axis, one->angle + two->angle, {two->map.A * one->map.A, two->map.A * one->map.b + two->map.b}};
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
    const bool isPoses = std::holds_alternative<PoseMotion<3>>(before.kind);
    auto result = motionOf(whole, originOf(isPoses ? before : after));
    if (!result) return {};
    result->start = before.start;
    result->end = after.end;
    return result;
}

std::optional<PinMotion> ledRigidly(const PinMotion& motion, const MotionTime& part, const Vec3& place,
                                    const Vec3& by, double first, double last) {
    if (!turnsOnly(motion)) return {};
    const Trajectory<3> trajectory(motion);
    PoseMotion<3> poses;
    poses.hasOwnTimes = true;
    RotationVector<3> rotation = RotationVector<3>::Zero();
    for (const double time : poseTimes(part, trajectory.breakTimes())) {
        const AffineMap<3> map = trajectory.at(time, Side::Before).position;
        if ((map.A.transpose() * map.A - Mat3::Identity()).norm() > kRigid) return {};
        const double share = (time - part.start) / (part.end - part.start);
        rotation = rotationOf(map.A, rotation);
        poses.times.push_back(time);
        poses.poses.push_back({map(place) + std::lerp(first, last, share) * by, rotation});
    }
    return PinMotion{std::move(poses), part.start, part.end};
}

std::optional<Vec3> startOfRigid(const PinMotion& motion, double time, const Vec3& place) {
    if (!turnsOnly(motion)) return {};
    const AffineMap<3> map = Trajectory<3>(motion).at(time, Side::Before).position;
    return map.A.transpose() * (place - map.b);
}

}  // namespace wend
