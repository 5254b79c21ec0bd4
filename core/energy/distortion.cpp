#include "core/energy/distortion.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "core/energy/cell_energy.h"

namespace wend {
namespace {

struct CellDistortion {
    double angle = 0, volume = 0, metric = 0;
};

/// docs/method.md (24)–(26): Σ_pairs (σj/σk + σk/σj − 2), Πσ + 1/Πσ − 2, and Σ (σj − 1)² − Σ_pairs (σj − σk)²
/// / (d + 2).
template <int Dim>
CellDistortion measure(const Vec<Dim>& sigma) {
    CellDistortion d;
    for (int j = 0; j < Dim; ++j) {
        d.metric += (sigma[j] - 1) * (sigma[j] - 1);
        for (int k = 0; k < j; ++k) {
            const double difference = sigma[j] - sigma[k];
            d.angle +=
                difference * difference / (sigma[j] * sigma[k]);  // = σj/σk + σk/σj − 2 without cancellation
            d.metric -= difference * difference / (Dim + 2);
        }
    }
    const double product = sigma.prod();
    d.volume = (product - 1) * (product - 1) / product;
    return d;
}

/// Half the sum and half the difference of both, each of a conformal or anticonformal part of F.
Vec<2> singularValues(const Mat<2>& F) {
    const double kept = std::hypot(F(0, 0) + F(1, 1), F(1, 0) - F(0, 1)),
                 lost = std::hypot(F(0, 0) - F(1, 1), F(1, 0) + F(0, 1));
    return {(kept + lost) / 2, std::abs(kept - lost) / 2};
}

/// √(1 + δ) of the eigenvalues δ of the strain FᵀF − I, which is 0 where F is rigid, by the cosines of a
/// third of an angle. Where F is far from rigid, by rotations, which lose nothing there.
Vec<3> singularValues(const Mat<3>& F) {
    constexpr double kLeast = 0.05, kMost = 20;  // of the eigenvalues of FᵀF
    Mat<3> B = F.transpose() * F;
    B.diagonal().array() -= 1;
    const double mean = B.trace() / 3;
    B.diagonal().array() -= mean;
    const double size = std::sqrt(B.squaredNorm() / 6);
    Vec<3> delta = Vec<3>::Constant(mean);
    if (size > 0) {
        const double third = std::acos(std::clamp((B / size).determinant() / 2, -1.0, 1.0)) / 3;
        const double c = size * std::cos(third), s = std::sqrt(3.0) * size * std::sin(third);
        delta += Vec<3>(2 * c, s - c, -s - c);
    }
    if (!(1 + delta.minCoeff() > kLeast && 1 + delta.maxCoeff() < kMost))
        return Eigen::JacobiSVD<Mat<3>>(F).singularValues();
    return (1 + delta.array()).sqrt();
}

}  // namespace

template <int Dim>
Distortion distortion(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    Distortion result;
    for (auto* values : {&result.angle, &result.volume, &result.metric, &result.ratio})
        values->reserve(rest.cells.size());
    double restMeasure = 0, worst = -1;
    for (int c = 0; c < rest.cellCount(); ++c) {
        const Mat<Dim> restEdges = edgeMatrix<Dim>(rest.points, rest.cells[c]);
        const Mat<Dim> F = edgeMatrix<Dim>(pose, rest.cells[c]) * restEdges.inverse();
        const auto cell = measure<Dim>(singularValues(F));
        const double weight = std::abs(restEdges.determinant()), det = F.determinant();
        restMeasure += weight;
        result.totalAngle += weight * cell.angle;
        result.totalVolume += weight * cell.volume;
        result.totalMetric += weight * cell.metric;
        result.angle.push_back(cell.angle);
        result.volume.push_back(cell.volume);
        result.metric.push_back(cell.metric);
        result.ratio.push_back(det);
        if (!(det > 0)) ++result.flips;
        if (c == 0 || det < result.minDet) result.minDet = det;
        if (cell.metric > worst) {
            worst = cell.metric;
            result.worstCell = c;
        }
    }
    if (restMeasure > 0) {
        result.totalAngle /= restMeasure;
        result.totalVolume /= restMeasure;
        result.totalMetric /= restMeasure;
    }
    return result;
}

template Distortion distortion<2>(const SimplicialMesh<2>&, const Points<2>&);
template Distortion distortion<3>(const SimplicialMesh<3>&, const Points<3>&);

}  // namespace wend
