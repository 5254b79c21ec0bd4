#include "app/project/edits/curve_edits.h"
#include "app/project/design.h"

#include <algorithm>
#include <utility>

#include "core/mesh/decompositions.h"

namespace wend {

namespace {

/// Returns the cubic Bézier curve with the stroke's ends that is nearest to its points, by least squares over
/// the inner control points at the stroke's own times: Σ |B(tᵢ) − pᵢ|² → min.
std::vector<Vec3> fitted(const Recorded<3>& stroke) {
    const Vec3 a = stroke.points.front(), d = stroke.points.back();
    const double start = stroke.times.front(), span = stroke.times.back() - start;
    const auto count = static_cast<Eigen::Index>(stroke.points.size());
    if (count < 4) return {a, a + (d - a) / 3, a + (d - a) * 2 / 3, d};
    Eigen::MatrixX2d weights(count, 2);
    Eigen::Matrix<double, Eigen::Dynamic, 3> rest(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double t = (stroke.times[i] - start) / span, s = 1 - t;
        weights.row(i) << 3 * s * s * t, 3 * s * t * t;
        rest.row(i) = (stroke.points[i] - s * s * s * a - t * t * t * d).transpose();
    }
    const Eigen::Matrix<double, 2, 3> inner = leastSquares<2, 3>(weights, rest).X;
    return {a, inner.row(0).transpose(), inner.row(1).transpose(), d};
}

const PinMotion* lastMotion(const Design& design, int handle) {
    const auto& motions = design.handles.at(handle).motions;
    return motions.empty() ? nullptr : &motions.back();
}

}  // namespace

const CurveMotion<3>* lastCurve(const Design& design, int handle) {
    const auto& motions = design.handles.at(handle).motions;
    const auto* curve = motions.empty() ? nullptr : std::get_if<CurveMotion<3>>(&motions.back().kind);
    const bool goes = curve && std::any_of(curve->points.begin(), curve->points.end(),
                                           [&](const Vec3& p) { return p != curve->points.front(); });
    return goes ? curve : nullptr;
}

CurveMotion<3>* lastCurve(Design& design, int handle) {
    return const_cast<CurveMotion<3>*>(lastCurve(std::as_const(design), handle));
}

bool canBecomeCurve(const Design& design, int handle) {
    const PinMotion* motion = lastMotion(design, handle);
    return motion && (std::holds_alternative<Recorded<3>>(motion->kind) ||
                      std::holds_alternative<Translate<3>>(motion->kind));
}

std::optional<Design> withCurve(const Design& design, int handle, const Vec3& end) {
    if (!canBecomeCurve(design, handle)) return {};
    CurveMotion<3> curve;
    const PinMotion& motion = *lastMotion(design, handle);
    if (const auto* stroke = std::get_if<Recorded<3>>(&motion.kind)) {
        curve.points = fitted(*stroke);
    } else {
        const Vec3 by = std::get<Translate<3>>(motion.kind).by;
        curve.points = {end - by, end - by * 2 / 3, end - by / 3, end};
    }
    Design next = design;
    next.handles[handle].motions.back().kind = curve;
    return next;
}

}  // namespace wend
