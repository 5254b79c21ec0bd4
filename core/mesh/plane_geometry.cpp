#include "core/mesh/plane_geometry.h"

#include <algorithm>

namespace wend {

Vec<2> nearestOnSegment(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b) {
    const Vec<2> along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp(along.dot(p - a) / squared, 0.0, 1.0) : 0.0;
    return a + t * along;
}

double distanceToSegment(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b) {
    return (p - nearestOnSegment(p, a, b)).norm();
}

double loopArea(const std::vector<Vec<2>>& loop) {
    double twice = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec<2> p = loop[k] - loop[0], q = loop[(k + 1) % loop.size()] - loop[0];
        twice += p.x() * q.y() - p.y() * q.x();
    }
    return twice / 2;
}

}  // namespace wend
