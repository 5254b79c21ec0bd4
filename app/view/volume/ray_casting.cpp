#include "app/view/volume/ray_casting.h"

#include <limits>

namespace wend {

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

}  // namespace wend
