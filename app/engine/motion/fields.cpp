#include "app/engine/motion/fields.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/energy/cell_energy.h"
#include "core/mesh/decompositions.h"

namespace wend {

template <int Dim>
double phiAt(const PosedFrame<Dim>& frame, const Points<Dim>&, int cell) {
    return frame.material ? frame.material->phi[cell] : 0;
}

template <int Dim>
double stiffnessAt(const PosedFrame<Dim>& frame, const Points<Dim>&, int cell) {
    if (!frame.material || frame.material->anisotropy.empty()) return 1;
    return symmetricEigenvalues<Dim>(frame.material->anisotropy[cell]).maxCoeff();
}

/// Returns the shear. Directions at 45° between the longest and the shortest axis of the deformation enclose
/// 2 arctan(σ_min/σ_max).
template <int Dim>
double shearAt(const PosedFrame<Dim>& frame, const Points<Dim>&, int cell) {
    const Cell<Dim>& corners = frame.rest->cells[cell];
    const Mat<Dim> F =
        edgeMatrix<Dim>(frame.pose, corners) * edgeMatrix<Dim>(frame.rest->points, corners).inverse();
    const Vec<Dim> sigma = singularValues<Dim>(F);
    return 90 - 360 / std::numbers::pi * std::atan2(sigma.minCoeff(), sigma.maxCoeff());
}

template <int Dim>
double wayAt(const PosedFrame<Dim>& frame, const Points<Dim>&, int cell) {
    Vec<Dim> way = Vec<Dim>::Zero();
    for (const int v : frame.rest->cells[cell])
        way += (frame.pose.col(v) - frame.rest->points.col(v)) / (Dim + 1);
    return way.norm();
}

/// The area of an equilateral triangle is √3/4 a², the volume of a regular tetrahedron a³/(6√2).
template <int Dim>
double sizeAt(const PosedFrame<Dim>& frame, const Points<Dim>&, int cell) {
    const double measure = std::abs(cellMeasure<Dim>(frame.rest->points, frame.rest->cells[cell]));
    return Dim == 2 ? std::sqrt(4 / std::sqrt(3.0) * measure) : std::cbrt(6 * std::sqrt(2.0) * measure);
}

template <int Dim>
double speedAt(const PosedFrame<Dim>& frame, const Points<Dim>& velocity, int cell) {
    Vec<Dim> mean = Vec<Dim>::Zero();
    for (const int v : frame.rest->cells[cell])
        if (velocity.cols()) mean += velocity.col(v) / (Dim + 1);
    return mean.norm();
}

template <int Dim>
double influenceOn(const PosedFrame<Dim>& frame, const Points<Dim>& influence, int cell) {
    return 100 * speedAt<Dim>(frame, influence, cell);
}

template <int Dim>
Points<Dim> velocityBetween(const FrameTrack& track, const PosedFrame<Dim>& frame) {
    const auto& frames = track.frames();
    const auto it = std::find_if(frames.begin(), frames.end(),
                                 [&](const FramePtr& other) { return other.get() == &frame; });
    if (it == frames.end()) return Points<Dim>::Zero(Dim, frame.pose.cols());
    const auto from = posed<Dim>(it == frames.begin() ? *it : *std::prev(it));
    const auto to = posed<Dim>(std::next(it) == frames.end() ? *it : *std::next(it));
    const bool fits = from->rest == frame.rest && to->rest == frame.rest && to->time > from->time;
    if (!fits) return Points<Dim>::Zero(Dim, frame.pose.cols());
    return (to->pose - from->pose) / (to->time - from->time);
}

#define WEND_INSTANTIATE(Dim)                                                          \
    template double phiAt<Dim>(const PosedFrame<Dim>&, const Points<Dim>&, int);       \
    template double stiffnessAt<Dim>(const PosedFrame<Dim>&, const Points<Dim>&, int); \
    template double shearAt<Dim>(const PosedFrame<Dim>&, const Points<Dim>&, int);     \
    template double wayAt<Dim>(const PosedFrame<Dim>&, const Points<Dim>&, int);       \
    template double sizeAt<Dim>(const PosedFrame<Dim>&, const Points<Dim>&, int);      \
    template double speedAt<Dim>(const PosedFrame<Dim>&, const Points<Dim>&, int);     \
    template double influenceOn<Dim>(const PosedFrame<Dim>&, const Points<Dim>&, int); \
    template Points<Dim> velocityBetween<Dim>(const FrameTrack&, const PosedFrame<Dim>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
