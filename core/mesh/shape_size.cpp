#include "core/mesh/shape_size.h"

#include <cmath>

#include "core/mesh/cell_geometry.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Sums the moments relative to a vertex, since far from zero digits would be lost.
template <int Dim>
ShapeSize<Dim> shapeSize(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells) {
    if (cells.empty()) return {};
    const Vec<Dim> origin = points.col(cells[0][0]);  // far from zero digits would be lost
    double measure = 0, moment = 0;
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const auto& cell : cells) {
        const double V = std::abs(cellMeasure<Dim>(points, cell));
        measure += V;
        sum += V * (centroid<Dim>(points, cell) - origin);
    }
    const Vec<Dim> mean = origin + sum / measure;
    for (const auto& cell : cells) {
        const Vec<Dim> c = centroid<Dim>(points, cell);
        double spread = 0;
        for (int v : cell) spread += (points.col(v) - c).squaredNorm();
        moment += std::abs(cellMeasure<Dim>(points, cell)) *
                  ((c - mean).squaredNorm() + spread / ((Dim + 1) * (Dim + 2)));
    }
    return {mean, std::sqrt(12 * moment / measure)};
}

template ShapeSize<2> shapeSize<2>(const Points2&, const std::vector<Cell<2>>&);
template ShapeSize<3> shapeSize<3>(const Points3&, const std::vector<Cell<3>>&);

}  // namespace wend
