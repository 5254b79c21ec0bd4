#pragma once

#include <optional>
#include <vector>

#include "core/motion/curve.h"
#include "core/motion/handle.h"

namespace wend {

/// Relation of the two directions at an inner joint of a Bézier chain. It is not stored: a joint with
/// opposite directions is aligned, and automatic if they also equal automaticArms().
enum class JointKind { Free, Aligned, Automatic };

/// Returns the joint (0, 1, … k) that a control point of a chain of 3k + 1 is or belongs to.
inline int jointOf(int point) {
    return (point + 1) / 3;
}
/// Returns whether the joint has a direction on either side.
inline bool isInnerJoint(const std::vector<Vec3>& points, int joint) {
    return joint > 0 && 3 * joint + 1 < static_cast<int>(points.size());
}

/// Returns the kind of every joint; ends have one direction and count as free.
std::vector<JointKind> jointKinds(const std::vector<Vec3>& points);
/// Returns the chain with another kind of inner joint. Aligned: both directions rotate to their mean and keep
/// their lengths. Automatic: parallel to the line through the neighbouring joints, a third of the distance to
/// each.
std::vector<Vec3> withJointKind(std::vector<Vec3> points, int joint, JointKind kind);

/// Returns the chain after a control point was moved. A joint carries its directions along, and automatic
/// neighbours adapt; a direction rotates the opposite one unless the joint is free.
std::vector<Vec3> withMovedPoint(std::vector<Vec3> points, const std::vector<JointKind>& kinds, int point,
                                 const Vec3& by);

/// Returns the same curve with another joint at v ∈ ]0, 1[ of a piece (de Casteljau). The time at which it is
/// passed changes, because every piece takes the same share.
std::vector<Vec3> splitBezier(const std::vector<Vec3>& points, int piece, double v);
/// Returns the chain without a joint, which must not be the first. The neighbours' directions are lengthened
/// such that this exactly reverts splitBezier(). Without the last joint the curve ends at the one before.
std::vector<Vec3> withoutJoint(std::vector<Vec3> points, int joint);

/// A point of a path that is drawn, with a direction on either side: opposite ones where it is smooth.
struct DrawnJoint {
    Vec3 at;
    Vec3 out = Vec3::Zero(), in = Vec3::Zero();  // of a corner
};
/// Returns the chain through at least two joints. A missing direction becomes a third of the distance to the
/// neighbour, so that the motion does not stop there.
std::vector<Vec3> bezierThrough(const std::vector<DrawnJoint>& joints);

/// Returns the curve that a motion follows, as pieces in the order of its points.
Curve<3> curveOf(const CurveMotion<3>& motion);
/// Returns the piece that starts at a point or contains it; the last piece for the end.
int pieceBehind(const CurveMotion<3>& motion, int point);
/// Returns the curve with another point at v of a piece, exactly on the curve; the shape of a spline changes
/// a little.
CurveMotion<3> withPointOn(CurveMotion<3> motion, int piece, double v);
/// Returns the curve without a point (of a Bézier chain, without its joint); nothing for the first point, or
/// if too few would remain.
std::optional<CurveMotion<3>> withoutPoint(CurveMotion<3> motion, int point);

}  // namespace wend
