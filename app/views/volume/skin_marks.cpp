#include "app/views/volume/skin_marks.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace wend {
namespace {

/// Finds the nearest of many points: they are sorted by x, and the search proceeds in both directions until
/// the x distance alone exceeds the best.
class NearestPoint {
  public:
    explicit NearestPoint(const Points<3>& points)
        : m_points(points), m_order(static_cast<std::size_t>(points.cols())) {
        std::iota(m_order.begin(), m_order.end(), 0);
        std::stable_sort(m_order.begin(), m_order.end(),
                         [&](int a, int b) { return points(0, a) < points(0, b); });
    }

    /// The lowest of equally near ones; −1 if there are none.
    int to(const Vec<3>& p) const {
        int best = -1;
        double minimum = std::numeric_limits<double>::infinity();
        const auto look = [&](int i) {  // false once all that follow are further away
            const double across = m_points(0, i) - p.x();
            if (across * across > minimum) return false;
            const double distance = (m_points.col(i) - p).squaredNorm();
            if (distance < minimum || (distance == minimum && i < best)) best = i;
            minimum = std::min(minimum, distance);
            return true;
        };
        const auto middle = std::partition_point(m_order.begin(), m_order.end(),
                                                 [&](int i) { return m_points(0, i) < p.x(); });
        for (auto it = middle; it != m_order.end() && look(*it);) ++it;
        for (auto it = middle; it != m_order.begin() && look(*(it - 1));) --it;
        return best;
    }

  private:
    const Points<3>& m_points;
    std::vector<int> m_order;
};

}  // namespace

std::vector<int> nearestSkinPoints(const Skin& skin, const Points<3>& rest,
                                   const std::vector<Facet<3>>& border) {
    std::vector<int> nearest(static_cast<std::size_t>(rest.cols()), -1);
    const NearestPoint search(skin.points);
    for (const Facet<3>& facet : border) {
        if (facet.interior()) continue;
        for (const int v : facet.vertices)
            if (int& found = nearest[static_cast<std::size_t>(v)]; found < 0) found = search.to(rest.col(v));
    }
    return nearest;
}

}  // namespace wend
