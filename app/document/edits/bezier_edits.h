#pragma once

#include <optional>
#include <vector>

#include "core/motion/curve.h"
#include "core/motion/handle.h"

namespace wend {

/// How the two directions at an inner joint of a Bézier chain go together. Nothing of it is stored: a joint
/// whose directions are opposite is aligned, and automatic if they also are what automaticArms() says.
enum class JointKind { Free, Aligned, Automatic };

/// The joint (0, 1, … k) that a control point of a chain of 3k + 1 is or belongs to.
inline int jointOf(int point) {
    return (point + 1) / 3;
}
/// True for joints that have a direction on either side.
template <int Dim>
bool isInnerJoint(const std::vector<Vec<Dim>>& points, int joint) {
    return joint > 0 && 3 * joint + 1 < static_cast<int>(points.size());
}

/// Of every joint; the ends, with one direction each, count as free.
template <int Dim>
std::vector<JointKind> jointKinds(const std::vector<Vec<Dim>>& points);
/// The chain with other directions at an inner joint. Aligned: both turn to their mean and keep their
/// lengths. Automatic: along the line through the neighbouring joints, a third as long as the way to each.
template <int Dim>
std::vector<Vec<Dim>> withJointKind(std::vector<Vec<Dim>> points, int joint, JointKind kind);

/// The chain after a control point was moved. A joint takes its directions along, automatic joints beside it
/// follow; a direction turns the other one of a joint that is not free.
template <int Dim>
std::vector<Vec<Dim>> withMovedPoint(std::vector<Vec<Dim>> points, const std::vector<JointKind>& kinds,
                                     int point, const Vec<Dim>& by);

/// The same curve with another joint at v ∈ ]0, 1[ of a piece (de Casteljau). The time at which it is passed
/// changes: every piece takes the same share.
template <int Dim>
std::vector<Vec<Dim>> splitBezier(const std::vector<Vec<Dim>>& points, int piece, double v);
/// The chain without a joint, which must not be the first; its neighbours' directions are lengthened such
/// that what splitBezier() did is undone exactly. Without the last one the curve ends at the one before.
template <int Dim>
std::vector<Vec<Dim>> withoutJoint(std::vector<Vec<Dim>> points, int joint);

/// A point of a path that is drawn, with a direction on either side: opposite ones where it is smooth.
template <int Dim>
struct DrawnJoint {
    Vec<Dim> at;
    Vec<Dim> out = Vec<Dim>::Zero(), in = Vec<Dim>::Zero();  // of a corner
};
/// The chain through two joints or more. Where a joint has no direction, it gets one of a third of the way to
/// what is there: a motion does not rest in it.
template <int Dim>
std::vector<Vec<Dim>> bezierThrough(const std::vector<DrawnJoint<Dim>>& joints);

/// The curve that a motion follows, as pieces in the order of its points.
template <int Dim>
Curve<Dim> curveOf(const CurveMotion<Dim>& motion);
/// The piece that begins at a point, or that it lies in; the last one for the end.
template <int Dim>
int pieceBehind(const CurveMotion<Dim>& motion, int point);
/// A point more at v of a piece: exactly on the curve; a spline's shape changes a little.
template <int Dim>
CurveMotion<Dim> withPointOn(CurveMotion<Dim> motion, int piece, double v);
/// Without a point (of a Bézier chain: without the joint that it belongs to); nothing if it is the first, or
/// if too few would be left.
template <int Dim>
std::optional<CurveMotion<Dim>> withoutPoint(CurveMotion<Dim> motion, int point);

}  // namespace wend
