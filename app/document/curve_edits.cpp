#include "app/document/curve_edits.h"

#include <Eigen/QR>

namespace wend {

namespace {

/// The cubic Bézier curve with the stroke's ends that is nearest to its points, by least squares over the
/// inner control points at the stroke's own times: Σ |B(tᵢ) − pᵢ|² → min.
std::vector<Vec<3>> fitted(const Recorded<3>& stroke) {
    const Vec<3> a = stroke.points.front(), d = stroke.points.back();
    const double start = stroke.times.front(), span = stroke.times.back() - start;
    const auto count = static_cast<Eigen::Index>(stroke.points.size());
    if (count < 4) return {a, a + (d - a) / 3, a + (d - a) * 2 / 3, d};
    Eigen::MatrixX2d weights(count, 2);
    Eigen::MatrixX3d rest(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double t = (stroke.times[i] - start) / span, s = 1 - t;
        weights.row(i) << 3 * s * s * t, 3 * s * t * t;
        rest.row(i) = (stroke.points[i] - s * s * s * a - t * t * t * d).transpose();
    }
    const Eigen::Matrix<double, 2, 3> inner = weights.colPivHouseholderQr().solve(rest);
    return {a, inner.row(0).transpose(), inner.row(1).transpose(), d};
}

const Motion<3>* lastMotion(const Project& project, int handle) {
    const auto& motions = std::get<Design<3>>(project.design).handles.at(handle).motions;
    return motions.empty() ? nullptr : &motions.back();
}

}  // namespace

CurveMotion<3>* lastCurve(Project& project, int handle) {
    auto& motions = std::get<Design<3>>(project.design).handles.at(handle).motions;
    auto* curve = motions.empty() ? nullptr : std::get_if<CurveMotion<3>>(&motions.back().kind);
    const bool goes = curve && (curve->points.back() - curve->points.front()).norm() > 0;
    return goes ? curve : nullptr;
}

bool canBecomeCurve(const Project& project, int handle) {
    const Motion<3>* motion = lastMotion(project, handle);
    return motion && (std::holds_alternative<Recorded<3>>(motion->kind) ||
                      std::holds_alternative<Translate<3>>(motion->kind));
}

std::optional<Project> withCurve(const Project& project, int handle, const Vec<3>& end) {
    if (!canBecomeCurve(project, handle)) return {};
    CurveMotion<3> curve;
    const Motion<3>& motion = *lastMotion(project, handle);
    if (const auto* stroke = std::get_if<Recorded<3>>(&motion.kind)) {
        curve.points = fitted(*stroke);
    } else {
        const Vec<3> by = std::get<Translate<3>>(motion.kind).by;
        curve.points = {end - by, end - by * 2 / 3, end - by / 3, end};
    }
    Project next = project;
    std::get<Design<3>>(next.design).handles[handle].motions.back().kind = curve;
    return next;
}

}  // namespace wend
