#include "app/window/surface/surface_place.h"

#include <Eigen/Geometry>
#include <limits>

namespace wend {

Points<3> surroundingsOf(const Surface& surface, const std::vector<int>& triangles) {
    Points<3> corners(3, static_cast<Eigen::Index>(3 * triangles.size()));
    Eigen::Index count = 0;
    for (const int t : triangles)
        for (const int v : surface.triangles[t]) corners.col(count++) = surface.points.col(v);
    const Vec<3> centre = (corners.rowwise().minCoeff() + corners.rowwise().maxCoeff()) / 2;
    return (1.5 * (corners.colwise() - centre)).colwise() + centre;
}

std::vector<bool> notBefore(const Surface& surface, const Points<3>& place, const Vec<3>& direction) {
    const Vec<3> low = place.rowwise().minCoeff(), high = place.rowwise().maxCoeff();
    const Vec<3> centre = (low + high) / 2, along = direction.normalized();
    const double radius = (high - low).norm() / 2;
    std::vector<bool> kept(surface.triangles.size(), true);
    for (int t = 0; t < surface.triangleCount(); ++t) {
        double last = -std::numeric_limits<double>::infinity(), beside = last;
        for (const int v : surface.triangles[t]) {
            const Vec<3> away = surface.points.col(v) - centre;
            last = std::max(last, away.dot(along));
            beside = std::max(beside, -(away - away.dot(along) * along).norm());
        }
        kept[t] = last > -radius / 2 || -beside > 3 * radius;
    }
    return kept;
}

Vec<3> intoTriangle(const Surface& surface, int triangle) {
    const auto& t = surface.triangles[triangle];
    const Vec<3> a = surface.points.col(t[0]);
    const Vec<3> normal = (surface.points.col(t[1]) - a).cross(surface.points.col(t[2]) - a);
    if (!normal.allFinite() || normal.norm() == 0) return kAskew;
    return -normal.normalized() + Vec<3>(0.15, 0.25, -0.3);
}

}  // namespace wend
