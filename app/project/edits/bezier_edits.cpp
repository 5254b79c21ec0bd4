#include "app/project/edits/bezier_edits.h"

#include <algorithm>

namespace wend {

namespace {

constexpr double kParallel = 1e-6;       // sine of the angle below which two directions are one
constexpr double kSameArm = 1e-9;        // fraction of the distance between the neighbours
constexpr double kMinPieceShare = 0.02;  // of a piece that two are joined to

/// The directions at a joint, both in the direction of travel.
struct Arms {
    Vec3 in, out;
};

Arms armsOf(const std::vector<Vec3>& points, int joint) {
    const int j = 3 * joint;
    return {points[j] - points[j - 1], points[j + 1] - points[j]};
}

void setArms(std::vector<Vec3>& points, int joint, const Arms& arms) {
    const int j = 3 * joint;
    points[j - 1] = points[j] - arms.in;
    points[j + 1] = points[j] + arms.out;
}

Arms automaticArms(const std::vector<Vec3>& points, int joint) {
    const Vec3 &before = points[3 * joint - 3], &at = points[3 * joint], &after = points[3 * joint + 3];
    const double way = (after - before).norm();
    const Vec3 along = way > 0 ? Vec3((after - before) / way) : Vec3(Vec3::Zero());
    return {along * (at - before).norm() / 3, along * (after - at).norm() / 3};
}

JointKind kindOf(const std::vector<Vec3>& points, int joint) {
    const Arms arms = armsOf(points, joint);
    const double in = arms.in.norm(), out = arms.out.norm();
    if (in == 0 || out == 0) return JointKind::Free;
    if ((arms.in / in - arms.out / out).norm() > kParallel) return JointKind::Free;
    const Arms own = automaticArms(points, joint);
    const double size = (points[3 * joint + 3] - points[3 * joint - 3]).norm();
    const bool same = (arms.in - own.in).norm() + (arms.out - own.out).norm() <= kSameArm * size;
    return same ? JointKind::Automatic : JointKind::Aligned;
}

Arms alignedArms(const std::vector<Vec3>& points, int joint) {
    const Arms arms = armsOf(points, joint), own = automaticArms(points, joint);
    const double in = arms.in.norm(), out = arms.out.norm();
    if (in == 0 || out == 0) return own;
    Vec3 mean = arms.in / in + arms.out / out;
    if (mean.norm() < kParallel) mean = own.in;  // opposite directions
    if (mean.norm() == 0) return arms;
    mean.normalize();
    return {in * mean, out * mean};
}

/// Returns the position of the joint at which a chain was split: the first piece's share of the length.
double shareAt(const std::vector<Vec3>& points, int joint) {
    const Arms arms = armsOf(points, joint);
    const double in = arms.in.norm(), out = arms.out.norm();
    const bool smooth = in > 0 && out > 0 && (arms.in / in - arms.out / out).norm() <= kParallel;
    const double before = smooth ? in : (points[3 * joint] - points[3 * joint - 3]).norm();
    const double after = smooth ? out : (points[3 * joint + 3] - points[3 * joint]).norm();
    if (before + after == 0) return 0.5;
    return std::clamp(before / (before + after), kMinPieceShare, 1 - kMinPieceShare);
}

}  // namespace

std::vector<JointKind> jointKinds(const std::vector<Vec3>& points) {
    std::vector<JointKind> kinds;
    for (int joint = 0; joint <= jointOf(static_cast<int>(points.size()) - 1); ++joint)
        kinds.push_back(isInnerJoint(points, joint) ? kindOf(points, joint) : JointKind::Free);
    return kinds;
}

std::vector<Vec3> withJointKind(std::vector<Vec3> points, int joint, JointKind kind) {
    if (!isInnerJoint(points, joint)) return points;
    if (kind == JointKind::Aligned) setArms(points, joint, alignedArms(points, joint));
    if (kind == JointKind::Automatic) setArms(points, joint, automaticArms(points, joint));
    return points;
}

std::vector<Vec3> withMovedPoint(std::vector<Vec3> points, const std::vector<JointKind>& kinds, int point,
                                 const Vec3& by) {
    const int joint = jointOf(point), count = static_cast<int>(points.size());
    points[point] += by;
    if (point % 3 == 0) {
        if (point > 0) points[point - 1] += by;
        if (point + 1 < count) points[point + 1] += by;
        for (const int other : {joint - 1, joint, joint + 1})
            if (isInnerJoint(points, other) && kinds[other] == JointKind::Automatic)
                points = withJointKind(std::move(points), other, JointKind::Automatic);
        return points;
    }
    if (!isInnerJoint(points, joint) || kinds[joint] == JointKind::Free) return points;
    Arms arms = armsOf(points, joint);
    const bool movedOut = point == 3 * joint + 1;
    Vec3& led = movedOut ? arms.in : arms.out;
    const Vec3& leads = movedOut ? arms.out : arms.in;
    if (leads.norm() > 0) led = led.norm() * leads.normalized();
    setArms(points, joint, arms);
    return points;
}

std::vector<Vec3> splitBezier(const std::vector<Vec3>& points, int piece, double v) {
    const auto between = [v](const Vec3& a, const Vec3& b) -> Vec3 { return (1 - v) * a + v * b; };
    const Vec3* p = &points[3 * piece];
    const Vec3 a = between(p[0], p[1]), b = between(p[1], p[2]), c = between(p[2], p[3]);
    const Vec3 ab = between(a, b), bc = between(b, c), joint = between(ab, bc);
    std::vector<Vec3> result(points.begin(), points.begin() + 3 * piece + 1);
    result.insert(result.end(), {a, ab, joint, bc, c});
    result.insert(result.end(), points.begin() + 3 * piece + 3, points.end());
    return result;
}

std::vector<Vec3> withoutJoint(std::vector<Vec3> points, int joint) {
    const int j = 3 * joint;
    if (!isInnerJoint(points, joint)) {
        points.resize(points.size() - 3);
        return points;
    }
    const double v = shareAt(points, joint);
    const Vec3 first = points[j - 3], last = points[j + 3];
    points[j - 2] = first + (points[j - 2] - first) / v;
    points[j + 2] = last + (points[j + 2] - last) / (1 - v);
    points.erase(points.begin() + j - 1, points.begin() + j + 2);
    return points;
}

std::vector<Vec3> bezierThrough(const std::vector<DrawnJoint>& joints) {
    std::vector<Vec3> points = {joints.front().at};
    for (std::size_t i = 1; i < joints.size(); ++i) {
        const DrawnJoint &from = joints[i - 1], &to = joints[i];
        const Vec3 leaves = from.at + from.out, arrives = to.at + to.in;
        points.push_back(from.out.isZero() ? Vec3(from.at + (arrives - from.at) / 3) : leaves);
        points.push_back(to.in.isZero() ? Vec3(to.at + (leaves - to.at) / 3) : arrives);
        points.push_back(to.at);
    }
    return points;
}

Curve<3> curveOf(const CurveMotion<3>& motion) {
    switch (motion.interpolation) {
        case Interpolation::Bezier:
            return bezierCurve<3>(motion.points);
        case Interpolation::Spline:
            return splineCurve<3>(motion.points);
        case Interpolation::Polyline:
            break;
    }
    return polylineCurve<3>(motion.points);
}

int pieceBehind(const CurveMotion<3>& motion, int point) {
    const int last = static_cast<int>(curveOf(motion).pieces.size()) - 1;
    if (motion.interpolation == Interpolation::Bezier) return std::clamp(point / 3, 0, last);
    const auto kept = distinctPoints<3>(motion.points);
    const auto behind = std::upper_bound(kept.begin(), kept.end(), std::max(point, 0)) - kept.begin();
    return std::clamp(static_cast<int>(behind) - 1, 0, last);
}

CurveMotion<3> withPointOn(CurveMotion<3> motion, int piece, double v) {
    if (motion.interpolation == Interpolation::Bezier) {
        motion.points = splitBezier(motion.points, piece, v);
    } else {
        const Vec3 p = curveOf(motion).pieces[piece].value(v);
        std::vector<Vec3> points;  // the pieces are between these
        for (const int i : distinctPoints<3>(motion.points)) points.push_back(motion.points[i]);
        points.insert(points.begin() + piece + 1, p);
        motion.points = std::move(points);
    }
    return motion;
}

std::optional<CurveMotion<3>> withoutPoint(CurveMotion<3> motion, int point) {
    const bool bezier = motion.interpolation == Interpolation::Bezier;
    const std::size_t minimum = bezier ? 7 : 3;
    const int which = bezier ? jointOf(point) : point;
    if (which <= 0 || motion.points.size() < minimum) return {};
    if (bezier)
        motion.points = withoutJoint(std::move(motion.points), which);
    else
        motion.points.erase(motion.points.begin() + which);
    return motion;
}

// clang-format off
// clang-format on

}  // namespace wend
