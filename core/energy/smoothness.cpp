#include "core/energy/smoothness.h"

#include <Eigen/Geometry>

#include "core/mesh/cell_geometry.h"

namespace wend {
namespace {

double measureOf(const Points2& x, const std::array<int, 2>& f) {
    return (x.col(f[1]) - x.col(f[0])).norm();
}

double measureOf(const Points3& x, const std::array<int, 3>& f) {
    const Vec3 a = x.col(f[1]) - x.col(f[0]), b = x.col(f[2]) - x.col(f[0]);
    return 0.5 * a.cross(b).norm();
}

}  // namespace

template <int Dim>
double facetMeasure(const Points<Dim>& points, const std::array<int, Dim>& facet) {
    return measureOf(points, facet);
}

template <int Dim>
double smoothnessWeight(const Smoothing& smoothing, const Points<Dim>& points,
                        const std::array<int, Dim>& facet, const Cell<Dim>& i, const Cell<Dim>& j) {
    if (smoothing.kind == SmoothingKind::None) return 0;
    const double B = facetMeasure<Dim>(points, facet);
    if (smoothing.kind == SmoothingKind::Paper) return smoothing.lambda * B;
    const double h = (centroid<Dim>(points, j) - centroid<Dim>(points, i)).norm();
    return smoothing.length * smoothing.length * B / h;
}

#define WEND_INSTANTIATE(Dim)                                                                                \
    template double facetMeasure<Dim>(const Points<Dim>&, const std::array<int, Dim>&);                      \
    template double smoothnessWeight<Dim>(const Smoothing&, const Points<Dim>&, const std::array<int, Dim>&, \
                                          const Cell<Dim>&, const Cell<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
