#include "app/engine/motion/fields.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/energy/cell_energy.h"
#include "core/energy/distortion.h"
#include "core/mesh/cell_shape.h"
#include "core/mesh/decompositions.h"

namespace wend {
namespace {

template <int Dim>
double stiffness(const PosedFrame<Dim>& frame, int cell) {
    if (!frame.material || frame.material->anisotropy.empty()) return 1;
    return symmetricEigenvalues<Dim>(frame.material->anisotropy[cell]).maxCoeff();
}

/// Returns the largest change of a right angle in degrees: 0 for similarities, near 90 for degenerate cells.
/// Directions at 45° between the longest and the shortest axis of the deformation enclose
/// 2 arctan(σ_min/σ_max).
template <int Dim>
double shear(const PosedFrame<Dim>& frame, int cell) {
    const Cell<Dim>& corners = frame.rest->cells[cell];
    const Mat<Dim> F =
        edgeMatrix<Dim>(frame.pose, corners) * edgeMatrix<Dim>(frame.rest->points, corners).inverse();
    const Vec<Dim> sigma = singularValues<Dim>(F);
    return 90 - 360 / std::numbers::pi * std::atan2(sigma.minCoeff(), sigma.maxCoeff());
}

/// Returns the distance of the cell's centroid from its rest position.
template <int Dim>
double distanceFromRest(const PosedFrame<Dim>& frame, int cell) {
    Vec<Dim> way = Vec<Dim>::Zero();
    for (const int v : frame.rest->cells[cell])
        way += (frame.pose.col(v) - frame.rest->points.col(v)) / (Dim + 1);
    return way.norm();
}

/// Returns the edge length of a regular cell of the same rest measure: the area of an equilateral triangle is
/// √3/4 a², the volume of a regular tetrahedron a³/(6√2).
template <int Dim>
double cellSize(const PosedFrame<Dim>& frame, int cell) {
    const double measure = std::abs(cellMeasure<Dim>(frame.rest->points, frame.rest->cells[cell]));
    return Dim == 2 ? std::sqrt(4 / std::sqrt(3.0) * measure) : std::cbrt(6 * std::sqrt(2.0) * measure);
}

/// Returns the length of a field in the middle of a cell.
template <int Dim>
double lengthIn(const PosedFrame<Dim>& frame, const Eigen::MatrixXd& field, int cell) {
    Vec<Dim> mean = Vec<Dim>::Zero();
    for (const int v : frame.rest->cells[cell])
        if (field.cols() > 0) mean += field.col(v) / (Dim + 1);
    return mean.norm();
}

template <int Dim>
double valueIn(const PosedFrame<Dim>& frame, Measure measure, const Eigen::MatrixXd& field, int cell) {
    const auto shape = [&] { return cellShape<Dim>(frame.pose, frame.rest->cells[cell]); };
    switch (measure) {
        case Measure::Angle:
            return frame.distortion->angle[cell];
        case Measure::Area:
            return frame.distortion->ratio[cell];
        case Measure::Length:
            return frame.distortion->metric[cell];
        case Measure::Shear:
            return shear<Dim>(frame, cell);
        case Measure::Way:
            return distanceFromRest<Dim>(frame, cell);
        case Measure::Phi:
            return frame.material ? frame.material->phi[cell] : 0;
        case Measure::Stiffness:
            return stiffness<Dim>(frame, cell);
        case Measure::Speed:
            return lengthIn<Dim>(frame, field, cell);
        case Measure::Influence:
            return 100 * lengthIn<Dim>(frame, field, cell);
        case Measure::CellSize:
            return cellSize<Dim>(frame, cell);
        case Measure::ScaledJacobian:
            return shape().scaledJacobian;
        case Measure::AspectRatio:
            return shape().aspectRatio;
        case Measure::SmallestAngle:
            return 180 / std::numbers::pi * shape().minAngle;
    }
    return 0;
}

/// Calls a function with the frame as one of its dimension.
template <class Function>
auto withPosed(const ShapeFrame& frame, const Function& function) {
    return frame.dimension == 2 ? function(static_cast<const PosedFrame<2>&>(frame))
                                : function(static_cast<const PosedFrame<3>&>(frame));
}

template <int Dim>
Eigen::MatrixXd differenceIn(const FrameTrack& track, const PosedFrame<Dim>& frame) {
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

}  // namespace

double cellValue(const ShapeFrame& frame, Measure measure, int cell, const Eigen::MatrixXd& field) {
    return withPosed(frame, [&](const auto& posed) { return valueIn(posed, measure, field, cell); });
}

std::vector<double> cellValues(const ShapeFrame& frame, Measure measure, const Eigen::MatrixXd& field) {
    return withPosed(frame, [&](const auto& posed) {
        std::vector<double> values(posed.rest->cells.size());
        for (std::size_t c = 0; c < values.size(); ++c)
            values[c] = valueIn(posed, measure, field, static_cast<int>(c));
        return values;
    });
}

Eigen::MatrixXd velocityBetween(const FrameTrack& track, const ShapeFrame& frame) {
    return withPosed(frame, [&](const auto& posed) { return differenceIn(track, posed); });
}

}  // namespace wend
