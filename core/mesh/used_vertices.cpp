#include "core/mesh/used_vertices.h"

namespace wend {

template <int Dim>
std::vector<bool> usedVertices(Eigen::Index vertexCount, const std::vector<Cell<Dim>>& cells) {
    std::vector<bool> used(static_cast<std::size_t>(vertexCount), false);
    for (const auto& cell : cells)
        for (int v : cell) used[v] = true;
    return used;
}

template <int Dim>
Extent<Dim> extentOf(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells) {
    if (cells.empty()) return {};
    Extent<Dim> extent{points.col(cells[0][0]), points.col(cells[0][0])};
    for (const auto& cell : cells)
        for (int v : cell) {
            extent.low = extent.low.cwiseMin(points.col(v));
            extent.high = extent.high.cwiseMax(points.col(v));
        }
    return extent;
}

#define WEND_INSTANTIATE(Dim)                                                                  \
    template std::vector<bool> usedVertices<Dim>(Eigen::Index, const std::vector<Cell<Dim>>&); \
    template Extent<Dim> extentOf<Dim>(const Points<Dim>&, const std::vector<Cell<Dim>>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
