#include "app/project/edits/curve_edits.h"
#include "app/project/design.h"

#include <algorithm>
#include <utility>

#include "core/mesh/decompositions.h"

namespace wend {

namespace {

/// The cubic Bézier curve with the stroke's ends that is nearest to its points, by least squares over the
/// inner control points at the stroke's own times: Σ |B(tᵢ) − pᵢ|² → min.
template <int Dim>
std::vector<Vec<Dim>> fitted(const Recorded<Dim>& stroke) {
    const Vec<Dim> a = stroke.points.front(), d = stroke.points.back();
    const double start = stroke.times.front(), span = stroke.times.back() - start;
    const auto count = static_cast<Eigen::Index>(stroke.points.size());
    if (count < 4) return {a, a + (d - a) / 3, a + (d - a) * 2 / 3, d};
    Eigen::MatrixX2d weights(count, 2);
    Eigen::Matrix<double, Eigen::Dynamic, Dim> rest(count, Dim);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double t = (stroke.times[i] - start) / span, s = 1 - t;
        weights.row(i) << 3 * s * s * t, 3 * s * t * t;
        rest.row(i) = (stroke.points[i] - s * s * s * a - t * t * t * d).transpose();
    }
    const Eigen::Matrix<double, 2, Dim> inner = leastSquares<2, Dim>(weights, rest).X;
    return {a, inner.row(0).transpose(), inner.row(1).transpose(), d};
}

template <int Dim>
const Motion<Dim>* lastMotion(const Design<Dim>& design, int handle) {
    const auto& motions = design.handles.at(handle).motions;
    return motions.empty() ? nullptr : &motions.back();
}

}  // namespace

template <int Dim>
const CurveMotion<Dim>* lastCurve(const Design<Dim>& design, int handle) {
    const auto& motions = design.handles.at(handle).motions;
    const auto* curve = motions.empty() ? nullptr : std::get_if<CurveMotion<Dim>>(&motions.back().kind);
    const bool goes = curve && std::any_of(curve->points.begin(), curve->points.end(),
                                           [&](const Vec<Dim>& p) { return p != curve->points.front(); });
    return goes ? curve : nullptr;
}

template <int Dim>
CurveMotion<Dim>* lastCurve(Design<Dim>& design, int handle) {
    return const_cast<CurveMotion<Dim>*>(lastCurve(std::as_const(design), handle));
}

template <int Dim>
bool canBecomeCurve(const Design<Dim>& design, int handle) {
    const Motion<Dim>* motion = lastMotion(design, handle);
    return motion && (std::holds_alternative<Recorded<Dim>>(motion->kind) ||
                      std::holds_alternative<Translate<Dim>>(motion->kind));
}

template <int Dim>
std::optional<Design<Dim>> withCurve(const Design<Dim>& design, int handle, const Vec<Dim>& end) {
    if (!canBecomeCurve(design, handle)) return {};
    CurveMotion<Dim> curve;
    const Motion<Dim>& motion = *lastMotion(design, handle);
    if (const auto* stroke = std::get_if<Recorded<Dim>>(&motion.kind)) {
        curve.points = fitted<Dim>(*stroke);
    } else {
        const Vec<Dim> by = std::get<Translate<Dim>>(motion.kind).by;
        curve.points = {end - by, end - by * 2 / 3, end - by / 3, end};
    }
    Design<Dim> next = design;
    next.handles[handle].motions.back().kind = curve;
    return next;
}

#define WEND_INSTANTIATE(Dim)                                                 \
    template CurveMotion<Dim>* lastCurve<Dim>(Design<Dim>&, int);             \
    template const CurveMotion<Dim>* lastCurve<Dim>(const Design<Dim>&, int); \
    template bool canBecomeCurve<Dim>(const Design<Dim>&, int);               \
    template std::optional<Design<Dim>> withCurve<Dim>(const Design<Dim>&, int, const Vec<Dim>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
