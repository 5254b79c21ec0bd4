#include "core/energy/distortion.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "core/energy/cell_energy.h"
#include "core/energy/stretches.h"
#include "core/mesh/decompositions.h"

namespace wend {
namespace {

struct CellDistortion {
    double angle = 0, volume = 0, metric = 0;
};

/// Computes the measures of docs/method.md, (26)–(28): Σ_pairs (σj/σk + σk/σj − 2), Πσ + 1/Πσ − 2, and Σ (σj
/// − 1)² − Σ_pairs (σj − σk)² / (d + 2).
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

/// Computes the maps of the cells in batches of Stretches::kCells, so that their singular values take one
/// vector instruction for several cells, and hands them out one by one in the order of the cells. next() must
/// not be called more often than there are cells: lanes behind the last cell keep maps of earlier batches.
template <int Dim>
class Maps {
  public:
    Maps(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) : m_rest(rest), m_pose(pose) {}

    /// Values of one cell.
    struct Of {
        double weight;  // proportional to its volume at rest
        Vec<Dim> sigma;
        double determinant;
    };
    Of next() {
        const int i = m_next++ % kCells;
        if (i == 0) compute();
        Of map{m_weights[i], {}, m_stretches.determinant[i]};
        for (int k = 0; k < Dim; ++k) map.sigma[k] = m_stretches.sigma[k][i];
        if (!m_stretches.isExact[i]) map.sigma = singularValues<Dim>(mapAt(i));
        return map;
    }

  private:
    static constexpr int kCells = Stretches<Dim>::kCells;

    void compute() {
        for (int i = 0; i < kCells && m_placed < m_rest.cellCount(); ++i, ++m_placed) {
            const Cell<Dim>& cell = m_rest.cells[m_placed];
            const Mat<Dim> restEdges = edgeMatrix<Dim>(m_rest.points, cell);
            const Mat<Dim> F = edgeMatrix<Dim>(m_pose, cell) * restEdges.inverse();
            m_weights[i] = std::abs(restEdges.determinant());
            for (int k = 0; k < Dim * Dim; ++k) m_stretches.maps[k][i] = F.data()[k];
        }
        computeStretches(m_stretches);
    }
    Mat<Dim> mapAt(int i) const {
        Mat<Dim> F;
        for (int k = 0; k < Dim * Dim; ++k) F.data()[k] = m_stretches.maps[k][i];
        return F;
    }

    const SimplicialMesh<Dim>& m_rest;
    const Points<Dim>& m_pose;
    int m_next = 0, m_placed = 0;
    Stretches<Dim> m_stretches{};
    std::array<double, kCells> m_weights{};
};

}  // namespace

template <int Dim>
Distortion distortion(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    Distortion result;
    for (auto* values : {&result.angle, &result.volume, &result.metric, &result.ratio})
        values->reserve(rest.cells.size());
    double restMeasure = 0, worst = -1;
    Maps<Dim> maps(rest, pose);
    for (int c = 0; c < rest.cellCount(); ++c) {
        const auto [weight, sigma, det] = maps.next();
        const auto cell = measure<Dim>(sigma);
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

template Distortion distortion<2>(const SimplicialMesh<2>&, const Points2&);
template Distortion distortion<3>(const SimplicialMesh<3>&, const Points3&);

}  // namespace wend
