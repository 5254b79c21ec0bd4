#pragma once

#include <optional>
#include <vector>

#include "core/motion/curve.h"
#include "core/motion/handle.h"

namespace wend {

/// Relation of the two directions at an inner joint of a Bézier chain. It is not stored: a joint with
/// opposite directions is aligned, and automatic if they also equal automaticArms().
enum class JointKind { Free, Aligned, Automatic };

/// The joint (0, 1, … k) that a control point of a chain of 3k + 1 is or belongs to.
inline int jointOf(int point) {
    return (point + 1) / 3;
}
/// Returns whether the joint has a direction on either side.
template <int Dim>
bool isInnerJoint(const std::vector<Vec<Dim>>& points, int joint) {
    return joint > 0 && 3 * joint + 1 < static_cast<int>(points.size());
}

/// Returns the kind of every joint; ends have one direction and count as free.
template <int Dim>
std::vector<JointKind> jointKinds(const std::vector<Vec<Dim>>& points);
/// Returns the chain with another kind of inner joint. Aligned: both directions rotate to their mean and keep
/// their lengths. Automatic: parallel to the line through the neighbouring joints, a third of the distance to
/// each.
template <int Dim>
std::vector<Vec<Dim>> withJointKind(std::vector<Vec<Dim>> points, int joint, JointKind kind);

/// Returns the chain after a control point was moved. A joint carries its directions along, and automatic
/// neighbours adapt; a direction rotates the opposite one unless the joint is free.
template <int Dim>
std::vector<Vec<Dim>> withMovedPoint(std::vector<Vec<Dim>> points, const std::vector<JointKind>& kinds,
                                     int point, const Vec<Dim>& by);

/// Returns the same curve with another joint at v ∈ ]0, 1[ of a piece (de Casteljau). The time at which it is
/// passed changes, because every piece takes the same share.
template <int Dim>
std::vector<Vec<Dim>> splitBezier(const std::vector<Vec<Dim>>& points, int piece, double v);
/// Returns the chain without a joint, which must not be the first. The neighbours' directions are lengthened
/// such that this exactly reverts splitBezier(). Without the last joint the curve ends at the one before.
template <int Dim>
std::vector<Vec<Dim>> withoutJoint(std::vector<Vec<Dim>> points, int joint);

/// A point of a path that is drawn, with a direction on either side: opposite ones where it is smooth.
template <int Dim>
struct DrawnJoint {
    Vec<Dim> at;
    Vec<Dim> out = Vec<Dim>::Zero(), in = Vec<Dim>::Zero();  // of a corner
};
/// Returns the chain through at least two joints. A missing direction becomes a third of the distance to the
/// neighbour, so that the motion does not stop there.
template <int Dim>
std::vector<Vec<Dim>> bezierThrough(const std::vector<DrawnJoint<Dim>>& joints);

/// The curve that a motion follows, as pieces in the order of its points.
template <int Dim>
Curve<Dim> curveOf(const CurveMotion<Dim>& motion);
/// Returns the piece that starts at a point or contains it; the last piece for the end.
template <int Dim>
int pieceBehind(const CurveMotion<Dim>& motion, int point);
/// A point more at v of a piece: exactly on the curve; a spline's shape changes a little.
template <int Dim>
CurveMotion<Dim> withPointOn(CurveMotion<Dim> motion, int piece, double v);
/// Returns the curve without a point (of a Bézier chain, without its joint); nothing for the first point, or
/// if too few would remain.
template <int Dim>
std::optional<CurveMotion<Dim>> withoutPoint(CurveMotion<Dim> motion, int point);

}  // namespace wend
