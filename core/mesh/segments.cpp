#include "core/mesh/segments.h"

#include <algorithm>

namespace wend {

template <int Dim>
Vec<Dim> nearestOnSegment(const Vec<Dim>& p, const Vec<Dim>& a, const Vec<Dim>& b) {
    const Vec<Dim> along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp(along.dot(p - a) / squared, 0.0, 1.0) : 0.0;
    return a + t * along;
}

template <int Dim>
double distanceToSegment(const Vec<Dim>& p, const Vec<Dim>& a, const Vec<Dim>& b) {
    return (p - nearestOnSegment<Dim>(p, a, b)).norm();
}

bool crossesRay(const Vec2& a, const Vec2& b, const Vec2& p) {
    if ((a.y() > p.y()) == (b.y() > p.y())) return false;
    const double side = (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    return (side > 0) == (b.y() > a.y());
}

double loopArea(const std::vector<Vec2>& loop) {
    double twice = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 p = loop[k] - loop[0], q = loop[(k + 1) % loop.size()] - loop[0];
        twice += p.x() * q.y() - p.y() * q.x();
    }
    return twice / 2;
}

#define WEND_INSTANTIATE(Dim)                                                                   \
    template Vec<Dim> nearestOnSegment<Dim>(const Vec<Dim>&, const Vec<Dim>&, const Vec<Dim>&); \
    template double distanceToSegment<Dim>(const Vec<Dim>&, const Vec<Dim>&, const Vec<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)
WEND_INSTANTIATE(4)

}  // namespace wend
