#include "warp/coverage.h"

#include <algorithm>
#include <numeric>

namespace wend {
namespace {

bool before(const Vec<2>& a, const Vec<2>& b) {
    return a.y() < b.y() || (a.y() == b.y() && a.x() < b.x());
}

}  // namespace

TriangleRows::TriangleRows(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c)
    : TriangleRows(sorted({a, b, c})) {}

TriangleRows::Corners TriangleRows::sorted(Corners corners) {
    std::sort(corners.begin(), corners.end(), before);
    return corners;
}

std::vector<int> paintingOrder(int cells, const std::vector<float>& depth) {
    std::vector<int> order(static_cast<std::size_t>(cells));
    std::iota(order.begin(), order.end(), 0);
    if (!depth.empty())
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth[a] < depth[b]; });
    return order;
}

}  // namespace wend
