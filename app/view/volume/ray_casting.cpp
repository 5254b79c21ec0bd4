#include "app/view/volume/ray_casting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace wend {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

Vec<3> place(const CutSurface::Corner& c, const Points<3>& pose) {
    return (1 - c.weight) * pose.col(c.from) + c.weight * pose.col(c.to);
}

/// Distance along the ray, or infinity.
double distanceTo(const std::array<Vec<3>, 3>& x, const Ray& ray) {
    const Vec<3> e1 = x[1] - x[0], e2 = x[2] - x[0];
    const Vec<3> p = ray.direction.cross(e2);
    const double det = e1.dot(p);
    if (det == 0) return kNothing;
    const Vec<3> s = ray.origin - x[0];
    const double u = s.dot(p) / det;
    if (u < 0 || u > 1) return kNothing;
    const Vec<3> q = s.cross(e1);
    const double v = ray.direction.dot(q) / det;
    if (v < 0 || u + v > 1) return kNothing;
    const double t = e2.dot(q) / det;
    return t > 0 ? t : kNothing;
}

std::array<Vec<3>, 3> corners(const std::array<CutSurface::Corner, 3>& triangle, const Points<3>& pose) {
    return {place(triangle[0], pose), place(triangle[1], pose), place(triangle[2], pose)};
}

}  // namespace

SolidHit nearestHit(const CutSurface& surface, const Points<3>& pose, const Ray& ray) {
    SolidHit hit;
    double nearest = kNothing;
    std::size_t triangle = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const double distance = distanceTo(corners(surface.triangles[t], pose), ray);
        if (distance >= nearest) continue;
        nearest = distance;
        triangle = t;
    }
    if (nearest == kNothing) return hit;
    hit.cell = surface.cells[triangle];
    hit.point = ray.origin + nearest * ray.direction;
    double closest = kNothing;
    for (const auto& c : surface.triangles[triangle])
        for (int v : {c.from, c.to}) {
            const double distance = (pose.col(v) - hit.point).norm();
            if (distance < closest) hit.vertex = v;
            closest = std::min(closest, distance);
        }
    return hit;
}

void keepVisible(std::vector<int>& vertices, const CutSurface& surface, const Points<3>& pose,
                 const Camera& camera, const QSize& viewport) {
    const auto hidden = [&](int v) {
        const Vec<3> screen = camera.project(pose.col(v), viewport);
        const Ray ray = camera.ray(screen.head<2>(), viewport);
        const SolidHit hit = nearestHit(surface, pose, ray);
        const double depth = (pose.col(v) - ray.origin).dot(ray.direction);
        // A vertex of the surface is met by the ray itself, up to rounding.
        return hit.cell >= 0 && (hit.point - ray.origin).norm() < depth * (1 - 1e-4);
    };
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), hidden), vertices.end());
}

}  // namespace wend
