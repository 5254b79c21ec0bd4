#include "core/energy/distortion.h"

#include <Eigen/LU>
#include <Eigen/SVD>
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

template <int Dim>
Vec<Dim> singularValues(const Mat<Dim>& F) {
    return Eigen::JacobiSVD<Mat<Dim>>(F).singularValues();
}

}  // namespace

template <int Dim>
Distortion distortion(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    Distortion result;
    double restMeasure = 0, worst = -1;
    for (int c = 0; c < rest.cellCount(); ++c) {
        const Mat<Dim> restEdges = edgeMatrix<Dim>(rest.points, rest.cells[c]);
        const Mat<Dim> F = edgeMatrix<Dim>(pose, rest.cells[c]) * restEdges.inverse();
        const auto cell = measure<Dim>(singularValues<Dim>(F));
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
