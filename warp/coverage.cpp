#include "warp/coverage.h"

#include <algorithm>
#include <numeric>

namespace wend {
namespace {

bool before(const Vec<2>& a, const Vec<2>& b) {
    return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
}

/// Where the edge from the upper to the lower end is at height y.
double crossing(const Vec<2>& upper, const Vec<2>& lower, double y) {
    return upper.x() + (y - upper.y()) / (lower.y() - upper.y()) * (lower.x() - upper.x());
}

}  // namespace

TriangleRows::TriangleRows(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) : m_corners{a, b, c} {
    std::sort(m_corners.begin(), m_corners.end(), before);
}

Span TriangleRows::at(double y) const {
    const auto& [upper, middle, lower] = m_corners;
    const double along = crossing(upper, lower, y);
    const double other = y < middle.y() ? crossing(upper, middle, y) : crossing(middle, lower, y);
    return {std::min(along, other), std::max(along, other)};
}

std::vector<int> paintingOrder(int cells, const std::vector<float>& depth) {
    std::vector<int> order(static_cast<std::size_t>(cells));
    std::iota(order.begin(), order.end(), 0);
    if (!depth.empty())
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth[a] < depth[b]; });
    return order;
}

}  // namespace wend
