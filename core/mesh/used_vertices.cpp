#include "core/mesh/used_vertices.h"

#include <algorithm>
#include <numeric>

namespace wend {

template <int Dim>
std::vector<bool> usedVertices(Eigen::Index vertexCount, const std::vector<Cell<Dim>>& cells) {
    std::vector<bool> used(static_cast<std::size_t>(vertexCount), false);
    for (const auto& cell : cells)
        for (int v : cell) used[v] = true;
    return used;
}

/// Sorts the points lexicographically, which brings equal ones side by side.
template <int Dim>
std::vector<int> firstAtPlace(const Points<Dim>& points) {
    std::vector<int> order(static_cast<std::size_t>(points.cols()));
    std::iota(order.begin(), order.end(), 0);
    const auto before = [&](int a, int b) {
        return std::lexicographical_compare(points.col(a).begin(), points.col(a).end(), points.col(b).begin(),
                                            points.col(b).end());
    };
    std::stable_sort(order.begin(), order.end(), before);
    std::vector<int> first(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        first[order[i]] = i > 0 && !before(order[i - 1], order[i]) ? first[order[i - 1]] : order[i];
    return first;
}

template <int Dim>
std::vector<Twin> twinsOf(const SimplicialMesh<Dim>& mesh) {
    const std::vector<bool> used = usedVertices<Dim>(mesh.points.cols(), mesh.cells);
    if (std::ranges::all_of(used, [](bool has) { return has; })) return {};
    const std::vector<int> first = firstAtPlace<Dim>(mesh.points);
    std::vector<int> usedThere(first.size(), -1);  // by the first vertex of the place
    for (int v = mesh.vertexCount() - 1; v >= 0; --v)
        if (used[v]) usedThere[first[v]] = v;
    std::vector<Twin> twins;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (!used[v] && usedThere[first[v]] >= 0) twins.push_back({v, usedThere[first[v]]});
    return twins;
}

template <int Dim>
void takeAlong(const std::vector<Twin>& twins, Points<Dim>& points) {
    for (const auto& [vertex, of] : twins) points.col(vertex) = points.col(of).eval();
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
    template std::vector<Twin> twinsOf<Dim>(const SimplicialMesh<Dim>&);                       \
    template void takeAlong<Dim>(const std::vector<Twin>&, Points<Dim>&);                      \
    template std::vector<int> firstAtPlace<Dim>(const Points<Dim>&);                           \
    template std::vector<bool> usedVertices<Dim>(Eigen::Index, const std::vector<Cell<Dim>>&); \
    template Extent<Dim> extentOf<Dim>(const Points<Dim>&, const std::vector<Cell<Dim>>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
