#include "core/mesh/quality.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace wend {
namespace {

constexpr double degree = M_PI / 180;

/// Outward facet normals, scaled: n_k = −∇λ_k with λ_k the barycentric coordinates; the rows of the inverse
/// edge matrix. The angle between facets j and k is π − ∠(n_j, n_k): interior angles in 2D, dihedral ones in
/// 3D.
template <int Dim>
std::array<double, Dim*(Dim + 1) / 2> anglesOf(const Mat<Dim>& edges) {
    Eigen::Matrix<double, Dim, Dim + 1> normals;
    normals.template rightCols<Dim>() = -edges.inverse().transpose();
    normals.col(0) = -normals.template rightCols<Dim>().rowwise().sum();
    std::array<double, Dim*(Dim + 1) / 2> angles;
    int at = 0;
    for (int j = 0; j <= Dim; ++j)
        for (int k = 0; k < j; ++k) {
            const Vec<Dim> a = normals.col(j).stableNormalized(), b = normals.col(k).stableNormalized();
            // 2 atan2(|a + b|, |a − b|) is π − ∠(a, b), accurate also near 0, where acos is not
            angles[at++] = 2 * std::atan2((a + b).norm(), (a - b).norm());
        }
    return angles;
}

template <int Dim>
Mat<Dim> edgesOf(const Points<Dim>& points, const Cell<Dim>& cell) {
    Mat<Dim> edges;
    for (int k = 0; k < Dim; ++k) edges.col(k) = points.col(cell[k + 1]) - points.col(cell[0]);
    return edges;
}

template <std::size_t N>
void count(std::array<int, N>& histogram, double bin) {
    ++histogram[static_cast<std::size_t>(std::clamp(bin, 0.0, N - 1.0))];
}

template <int Dim>
double shortestEdge(const Points<Dim>& points, const Cell<Dim>& cell) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int j = 0; j <= Dim; ++j)
        for (int k = 0; k < j; ++k)
            shortest = std::min(shortest, (points.col(cell[j]) - points.col(cell[k])).norm());
    return shortest;
}

/// Returns the length of c, where the circumcentre relative to x0 has 2 e_k · c = |e_k|² for the edges e_k
/// from x0.
template <int Dim>
double circumradius(const Mat<Dim>& edges) {
    const Vec<Dim> squares = edges.colwise().squaredNorm().transpose() / 2;
    return (edges.inverse().transpose() * squares).norm();
}

}  // namespace

template <int Dim>
bool isFlat(const Points<Dim>& points, const Cell<Dim>& cell) {
    double longest = 0;
    for (int i = 0; i <= Dim; ++i)
        for (int j = 0; j < i; ++j)
            longest = std::max(longest, (points.col(cell[i]) - points.col(cell[j])).norm());
    return std::abs(cellMeasure<Dim>(points, cell)) <= 1e-14 * std::pow(longest, Dim);
}

template <int Dim>
CellQuality cellQuality(const Points<Dim>& points, const Cell<Dim>& cell) {
    const Mat<Dim> edges = edgesOf<Dim>(points, cell);
    CellQuality quality;
    quality.measure = cellMeasure<Dim>(points, cell);
    if (quality.measure == 0 || !std::isfinite(quality.measure)) {
        quality.radiusEdgeRatio = std::numeric_limits<double>::infinity();
        return quality;
    }
    const auto angles = anglesOf<Dim>(edges);
    quality.minAngle = *std::min_element(angles.begin(), angles.end());
    quality.radiusEdgeRatio = circumradius<Dim>(edges) / shortestEdge<Dim>(points, cell);
    return quality;
}

namespace {

template <int Dim>
void countCell(const SimplicialMesh<Dim>& mesh, int cell, const CellQuality& quality,
               QualitySummary& summary) {
    const double measure = std::abs(quality.measure), mean = summary.totalMeasure / mesh.cellCount();
    count(summary.measures, measure > 0 ? std::floor(std::log2(measure / mean)) + 8 : 0);
    count(summary.ratios, (quality.radiusEdgeRatio - 0.5) * 4);
    if (measure == 0) return;  // has no angles
    for (double angle : anglesOf<Dim>(edgesOf<Dim>(mesh.points, mesh.cells[cell]))) {
        summary.maxAngle = std::max(summary.maxAngle, angle);
        count(summary.allAngles, angle / degree / QualitySummary::binDegrees);
    }
}

}  // namespace

template <int Dim>
QualitySummary qualityOf(const SimplicialMesh<Dim>& mesh) {
    QualitySummary summary;
    if (mesh.cells.empty()) return summary;
    summary.minMeasure = summary.minAngle = std::numeric_limits<double>::infinity();
    for (int c = 0; c < mesh.cellCount(); ++c) {
        const auto quality = cellQuality<Dim>(mesh.points, mesh.cells[c]);
        const double measure = std::abs(quality.measure);
        summary.minMeasure = std::min(summary.minMeasure, measure);
        summary.maxMeasure = std::max(summary.maxMeasure, measure);
        summary.totalMeasure += measure;
        summary.meanMinAngle += quality.minAngle / mesh.cellCount();
        summary.maxRadiusEdgeRatio = std::max(summary.maxRadiusEdgeRatio, quality.radiusEdgeRatio);
        const int bin = static_cast<int>(quality.minAngle / degree / QualitySummary::binDegrees);
        ++summary.angleHistogram[std::clamp(bin, 0, QualitySummary::binCount - 1)];
        if (quality.minAngle >= summary.minAngle) continue;
        summary.minAngle = quality.minAngle;
        summary.worstCell = c;
    }
    for (int c = 0; c < mesh.cellCount(); ++c)
        countCell<Dim>(mesh, c, cellQuality<Dim>(mesh.points, mesh.cells[c]), summary);
    return summary;
}

#define WEND_INSTANTIATE(Dim)                                                    \
    template bool isFlat<Dim>(const Points<Dim>&, const Cell<Dim>&);             \
    template CellQuality cellQuality<Dim>(const Points<Dim>&, const Cell<Dim>&); \
    template QualitySummary qualityOf<Dim>(const SimplicialMesh<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
