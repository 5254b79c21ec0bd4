#include "app/project/edits/bezier_edits.h"

#include <algorithm>

namespace wend {

namespace {

constexpr double kParallel = 1e-6;       // sine of the angle below which two directions are one
constexpr double kSameArm = 1e-9;        // fraction of the distance between the neighbours
constexpr double kMinPieceShare = 0.02;  // of a piece that two are joined to

/// The directions at a joint, both in the direction of travel.
template <int Dim>
struct Arms {
    Vec<Dim> in, out;
};

template <int Dim>
Arms<Dim> armsOf(const std::vector<Vec<Dim>>& points, int joint) {
    const int j = 3 * joint;
    return {points[j] - points[j - 1], points[j + 1] - points[j]};
}

template <int Dim>
void setArms(std::vector<Vec<Dim>>& points, int joint, const Arms<Dim>& arms) {
    const int j = 3 * joint;
    points[j - 1] = points[j] - arms.in;
    points[j + 1] = points[j] + arms.out;
}

template <int Dim>
Arms<Dim> automaticArms(const std::vector<Vec<Dim>>& points, int joint) {
    const Vec<Dim>&before = points[3 * joint - 3], &at = points[3 * joint], &after = points[3 * joint + 3];
    const double way = (after - before).norm();
    const Vec<Dim> along = way > 0 ? Vec<Dim>((after - before) / way) : Vec<Dim>(Vec<Dim>::Zero());
    return {along * (at - before).norm() / 3, along * (after - at).norm() / 3};
}

template <int Dim>
JointKind kindOf(const std::vector<Vec<Dim>>& points, int joint) {
    const Arms<Dim> arms = armsOf<Dim>(points, joint);
    const double in = arms.in.norm(), out = arms.out.norm();
    if (in == 0 || out == 0) return JointKind::Free;
    if ((arms.in / in - arms.out / out).norm() > kParallel) return JointKind::Free;
    const Arms<Dim> own = automaticArms<Dim>(points, joint);
    const double size = (points[3 * joint + 3] - points[3 * joint - 3]).norm();
    const bool same = (arms.in - own.in).norm() + (arms.out - own.out).norm() <= kSameArm * size;
    return same ? JointKind::Automatic : JointKind::Aligned;
}

template <int Dim>
Arms<Dim> alignedArms(const std::vector<Vec<Dim>>& points, int joint) {
    const Arms<Dim> arms = armsOf<Dim>(points, joint), own = automaticArms<Dim>(points, joint);
    const double in = arms.in.norm(), out = arms.out.norm();
    if (in == 0 || out == 0) return own;
    Vec<Dim> mean = arms.in / in + arms.out / out;
    if (mean.norm() < kParallel) mean = own.in;  // opposite directions
    if (mean.norm() == 0) return arms;
    mean.normalize();
    return {in * mean, out * mean};
}

/// Returns the position of the joint at which a chain was split: the first piece's share of the length.
template <int Dim>
double shareAt(const std::vector<Vec<Dim>>& points, int joint) {
    const Arms<Dim> arms = armsOf<Dim>(points, joint);
    const double in = arms.in.norm(), out = arms.out.norm();
    const bool smooth = in > 0 && out > 0 && (arms.in / in - arms.out / out).norm() <= kParallel;
    const double before = smooth ? in : (points[3 * joint] - points[3 * joint - 3]).norm();
    const double after = smooth ? out : (points[3 * joint + 3] - points[3 * joint]).norm();
    if (before + after == 0) return 0.5;
    return std::clamp(before / (before + after), kMinPieceShare, 1 - kMinPieceShare);
}

}  // namespace

template <int Dim>
std::vector<JointKind> jointKinds(const std::vector<Vec<Dim>>& points) {
    std::vector<JointKind> kinds;
    for (int joint = 0; joint <= jointOf(static_cast<int>(points.size()) - 1); ++joint)
        kinds.push_back(isInnerJoint<Dim>(points, joint) ? kindOf<Dim>(points, joint) : JointKind::Free);
    return kinds;
}

template <int Dim>
std::vector<Vec<Dim>> withJointKind(std::vector<Vec<Dim>> points, int joint, JointKind kind) {
    if (!isInnerJoint<Dim>(points, joint)) return points;
    if (kind == JointKind::Aligned) setArms<Dim>(points, joint, alignedArms<Dim>(points, joint));
    if (kind == JointKind::Automatic) setArms<Dim>(points, joint, automaticArms<Dim>(points, joint));
    return points;
}

template <int Dim>
std::vector<Vec<Dim>> withMovedPoint(std::vector<Vec<Dim>> points, const std::vector<JointKind>& kinds,
                                     int point, const Vec<Dim>& by) {
    const int joint = jointOf(point), count = static_cast<int>(points.size());
    points[point] += by;
    if (point % 3 == 0) {
        if (point > 0) points[point - 1] += by;
        if (point + 1 < count) points[point + 1] += by;
        for (const int other : {joint - 1, joint, joint + 1})
            if (isInnerJoint<Dim>(points, other) && kinds[other] == JointKind::Automatic)
                points = withJointKind<Dim>(std::move(points), other, JointKind::Automatic);
        return points;
    }
    if (!isInnerJoint<Dim>(points, joint) || kinds[joint] == JointKind::Free) return points;
    Arms<Dim> arms = armsOf<Dim>(points, joint);
    const bool movedOut = point == 3 * joint + 1;
    Vec<Dim>& led = movedOut ? arms.in : arms.out;
    const Vec<Dim>& leads = movedOut ? arms.out : arms.in;
    if (leads.norm() > 0) led = led.norm() * leads.normalized();
    setArms<Dim>(points, joint, arms);
    return points;
}

template <int Dim>
std::vector<Vec<Dim>> splitBezier(const std::vector<Vec<Dim>>& points, int piece, double v) {
    const auto between = [v](const Vec<Dim>& a, const Vec<Dim>& b) -> Vec<Dim> {
        return (1 - v) * a + v * b;
    };
    const Vec<Dim>* p = &points[3 * piece];
    const Vec<Dim> a = between(p[0], p[1]), b = between(p[1], p[2]), c = between(p[2], p[3]);
    const Vec<Dim> ab = between(a, b), bc = between(b, c), joint = between(ab, bc);
    std::vector<Vec<Dim>> result(points.begin(), points.begin() + 3 * piece + 1);
    result.insert(result.end(), {a, ab, joint, bc, c});
    result.insert(result.end(), points.begin() + 3 * piece + 3, points.end());
    return result;
}

template <int Dim>
std::vector<Vec<Dim>> withoutJoint(std::vector<Vec<Dim>> points, int joint) {
    const int j = 3 * joint;
    if (!isInnerJoint<Dim>(points, joint)) {
        points.resize(points.size() - 3);
        return points;
    }
    const double v = shareAt<Dim>(points, joint);
    const Vec<Dim> first = points[j - 3], last = points[j + 3];
    points[j - 2] = first + (points[j - 2] - first) / v;
    points[j + 2] = last + (points[j + 2] - last) / (1 - v);
    points.erase(points.begin() + j - 1, points.begin() + j + 2);
    return points;
}

template <int Dim>
std::vector<Vec<Dim>> bezierThrough(const std::vector<DrawnJoint<Dim>>& joints) {
    std::vector<Vec<Dim>> points = {joints.front().at};
    for (std::size_t i = 1; i < joints.size(); ++i) {
        const DrawnJoint<Dim>&from = joints[i - 1], &to = joints[i];
        const Vec<Dim> leaves = from.at + from.out, arrives = to.at + to.in;
        points.push_back(from.out.isZero() ? Vec<Dim>(from.at + (arrives - from.at) / 3) : leaves);
        points.push_back(to.in.isZero() ? Vec<Dim>(to.at + (leaves - to.at) / 3) : arrives);
        points.push_back(to.at);
    }
    return points;
}

template <int Dim>
Curve<Dim> curveOf(const CurveMotion<Dim>& motion) {
    switch (motion.interpolation) {
        case Interpolation::Bezier:
            return bezierCurve<Dim>(motion.points);
        case Interpolation::Spline:
            return splineCurve<Dim>(motion.points);
        case Interpolation::Polyline:
            break;
    }
    return polylineCurve<Dim>(motion.points);
}

template <int Dim>
int pieceBehind(const CurveMotion<Dim>& motion, int point) {
    const int last = static_cast<int>(curveOf<Dim>(motion).pieces.size()) - 1;
    if (motion.interpolation == Interpolation::Bezier) return std::clamp(point / 3, 0, last);
    const auto kept = distinctPoints<Dim>(motion.points);
    const auto behind = std::upper_bound(kept.begin(), kept.end(), std::max(point, 0)) - kept.begin();
    return std::clamp(static_cast<int>(behind) - 1, 0, last);
}

template <int Dim>
CurveMotion<Dim> withPointOn(CurveMotion<Dim> motion, int piece, double v) {
    if (motion.interpolation == Interpolation::Bezier) {
        motion.points = splitBezier<Dim>(motion.points, piece, v);
    } else {
        const Vec<Dim> p = curveOf<Dim>(motion).pieces[piece].value(v);
        std::vector<Vec<Dim>> points;  // the pieces are between these
        for (const int i : distinctPoints<Dim>(motion.points)) points.push_back(motion.points[i]);
        points.insert(points.begin() + piece + 1, p);
        motion.points = std::move(points);
    }
    return motion;
}

template <int Dim>
std::optional<CurveMotion<Dim>> withoutPoint(CurveMotion<Dim> motion, int point) {
    const bool bezier = motion.interpolation == Interpolation::Bezier;
    const std::size_t minimum = bezier ? 7 : 3;
    const int which = bezier ? jointOf(point) : point;
    if (which <= 0 || motion.points.size() < minimum) return {};
    if (bezier)
        motion.points = withoutJoint<Dim>(std::move(motion.points), which);
    else
        motion.points.erase(motion.points.begin() + which);
    return motion;
}

// clang-format off
#define WEND_INSTANTIATE(Dim)                                                                              \
    template std::vector<JointKind> jointKinds<Dim>(const std::vector<Vec<Dim>>&);                         \
    template std::vector<Vec<Dim>> withJointKind<Dim>(std::vector<Vec<Dim>>, int, JointKind);              \
    template std::vector<Vec<Dim>> withMovedPoint<Dim>(std::vector<Vec<Dim>>, const std::vector<JointKind>&, \
                                                       int, const Vec<Dim>&);                              \
    template std::vector<Vec<Dim>> splitBezier<Dim>(const std::vector<Vec<Dim>>&, int, double);            \
    template std::vector<Vec<Dim>> withoutJoint<Dim>(std::vector<Vec<Dim>>, int);                          \
    template std::vector<Vec<Dim>> bezierThrough<Dim>(const std::vector<DrawnJoint<Dim>>&);                \
    template Curve<Dim> curveOf<Dim>(const CurveMotion<Dim>&);                                             \
    template int pieceBehind<Dim>(const CurveMotion<Dim>&, int);                                           \
    template CurveMotion<Dim> withPointOn<Dim>(CurveMotion<Dim>, int, double);                             \
    template std::optional<CurveMotion<Dim>> withoutPoint<Dim>(CurveMotion<Dim>, int)
// clang-format on

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
