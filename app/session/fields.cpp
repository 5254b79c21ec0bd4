#include "app/session/fields.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace wend {

template <int Dim>
std::vector<double> phiOf(const PosedFrame<Dim>& frame) {
    return frame.material ? frame.material->phi : std::vector<double>(frame.rest->cells.size(), 0);
}

template <int Dim>
std::vector<double> stiffnessOf(const PosedFrame<Dim>& frame) {
    std::vector<double> values(frame.rest->cells.size(), 1);
    if (!frame.material || frame.material->anisotropy.empty()) return values;
    for (std::size_t c = 0; c < values.size(); ++c)
        values[c] =
            Eigen::SelfAdjointEigenSolver<Mat<Dim>>(frame.material->anisotropy[c], Eigen::EigenvaluesOnly)
                .eigenvalues()
                .maxCoeff();
    return values;
}

/// The area of an equilateral triangle is √3/4 a², the volume of a regular tetrahedron a³/(6√2).
template <int Dim>
std::vector<double> sizesOf(const PosedFrame<Dim>& frame) {
    std::vector<double> values;
    values.reserve(frame.rest->cells.size());
    for (const Cell<Dim>& cell : frame.rest->cells) {
        const double measure = std::abs(cellMeasure<Dim>(frame.rest->points, cell));
        values.push_back(Dim == 2 ? std::sqrt(4 / std::sqrt(3.0) * measure)
                                  : std::cbrt(6 * std::sqrt(2.0) * measure));
    }
    return values;
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

template <int Dim>
std::vector<double> speedOf(const PosedFrame<Dim>& frame, const Points<Dim>& velocity) {
    std::vector<double> values;
    for (const Cell<Dim>& cell : frame.rest->cells) {
        Vec<Dim> mean = Vec<Dim>::Zero();
        for (const int v : cell) mean += velocity.col(v) / (Dim + 1);
        values.push_back(mean.norm());
    }
    return values;
}

#define WEND_INSTANTIATE(Dim)                                                             \
    template std::vector<double> phiOf<Dim>(const PosedFrame<Dim>&);                      \
    template std::vector<double> stiffnessOf<Dim>(const PosedFrame<Dim>&);                \
    template std::vector<double> sizesOf<Dim>(const PosedFrame<Dim>&);                    \
    template Points<Dim> velocityBetween<Dim>(const FrameTrack&, const PosedFrame<Dim>&); \
    template std::vector<double> speedOf<Dim>(const PosedFrame<Dim>&, const Points<Dim>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
