#include "app/views/volume/ray_casting.h"

#include <limits>
#include <utility>

namespace wend {

namespace {

/// Adds the nearest corner of the triangle.
SolidHit solidHit(const CutSurface& surface, const Points<3>& pose, const Ray& ray,
                  const TriangleTree::Hit& hit) {
    SolidHit result;
    if (hit.triangle < 0) return result;
    result.cell = surface.cells[hit.triangle];
    result.point = ray.origin + hit.distance * ray.direction;
    double closest = std::numeric_limits<double>::infinity();
    for (const auto& c : surface.triangles[hit.triangle])
        for (const int v : {c.from, c.to}) {
            const double distance = (pose.col(v) - result.point).norm();
            if (distance < closest) result.vertex = v;
            closest = std::min(closest, distance);
        }
    return result;
}

}  // namespace

void RayCasting::takeSurface(CutSurface surface) {
    m_surface = std::move(surface);
    m_surfaceStale = true;
}

const TriangleTree& RayCasting::tree(const Points<3>& pose) {
    if (m_surfaceStale) {
        m_points.emplace(m_surface);
        m_tree = TriangleTree(m_points->at(pose), std::move(m_points->triangles));
    } else if (m_poseStale) {
        m_tree.refit(m_points->at(pose));
    }
    m_surfaceStale = m_poseStale = false;
    return m_tree;
}

SolidHit RayCasting::hit(const Ray& ray, const Points<3>& pose) {
    const TriangleTree::Hit hit = tree(pose).firstHit(ray.origin, ray.direction);
    m_visited = hit.visited;
    return solidHit(m_surface, pose, ray, hit);
}

}  // namespace wend
