#include "core/mesh/simplicial_mesh.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/error.h"
#include "core/mesh/quality.h"

namespace wend {
namespace {

constexpr double factorial(int n) {
    return n <= 1 ? 1 : n * factorial(n - 1);
}

/// Returns the facet opposite to local vertex k, ordered so that it runs along the boundary of a positive
/// cell.
template <int Dim>
std::array<int, Dim> oppositeFacet(const Cell<Dim>& cell, int k) {
    std::array<int, Dim> facet;
    for (int i = 0, at = 0; i <= Dim; ++i)
        if (i != k) facet[at++] = cell[i];
    const bool odd = (k % 2) != 0;
    if (odd) std::swap(facet[0], facet[1]);
    return facet;
}

template <std::size_t N>
std::array<int, N> sorted(std::array<int, N> ids) {
    std::sort(ids.begin(), ids.end());
    return ids;
}

template <int Dim>
std::vector<int> cellsPerVertex(const SimplicialMesh<Dim>& mesh) {
    std::vector<int> count(static_cast<std::size_t>(mesh.vertexCount()), 0);
    for (const auto& cell : mesh.cells)
        for (int v : cell) ++count[v];
    return count;
}

template <int Dim>
void requireFinite(const SimplicialMesh<Dim>& mesh) {
    for (int i = 0; i < mesh.vertexCount(); ++i)
        if (!mesh.points.col(i).allFinite())
            throw InputError("vertex " + std::to_string(i) + " has a coordinate that is not a finite number");
}

/// Throws InputError for indices out of range and repeated vertices.
template <int Dim>
void requireIndices(const SimplicialMesh<Dim>& mesh) {
    for (int c = 0; c < mesh.cellCount(); ++c) {
        const auto ids = sorted(mesh.cells[c]);
        for (int id : ids)
            if (id < 0 || id >= mesh.vertexCount())
                throw InputError("cell " + std::to_string(c) + " names vertex " + std::to_string(id) +
                                 ", but there are only " + std::to_string(mesh.vertexCount()));
        if (std::adjacent_find(ids.begin(), ids.end()) != ids.end())
            throw InputError("cell " + std::to_string(c) + " names the same vertex twice");
    }
}

/// Throws InputError for two cells with the same vertices, which sorting brings side by side.
template <int Dim>
void requireNoDuplicates(const SimplicialMesh<Dim>& mesh) {
    std::vector<int> order(mesh.cells.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<Cell<Dim>> keys(mesh.cells.size());
    std::transform(mesh.cells.begin(), mesh.cells.end(), keys.begin(),
                   [](const auto& c) { return sorted(c); });
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] < keys[b]; });
    for (std::size_t i = 1; i < order.size(); ++i)
        if (keys[order[i]] == keys[order[i - 1]])
            throw InputError("cell " + std::to_string(order[i]) + " is a duplicate of cell " +
                             std::to_string(order[i - 1]));
}

/// Throws InputError for flat cells, and for cells of both orientations, of which the rarer ones are named as
/// inverted.
template <int Dim>
void requireOneOrientation(const SimplicialMesh<Dim>& mesh) {
    int negative = 0, firstNegative = -1, firstPositive = -1;
    for (int c = 0; c < mesh.cellCount(); ++c) {
        const double measure = cellMeasure<Dim>(mesh.points, mesh.cells[c]);
        if (isFlat<Dim>(mesh.points, mesh.cells[c]))
            throw InputError("cell " + std::to_string(c) + " has no " + (Dim == 2 ? "area" : "volume"));
        if (measure < 0) {
            ++negative;
            if (firstNegative < 0) firstNegative = c;
        } else if (firstPositive < 0) {
            firstPositive = c;
        }
    }
    if (firstNegative >= 0 && firstPositive >= 0) {
        const bool mostlyPositive = 2 * negative <= mesh.cellCount();
        throw InputError("cell " + std::to_string(mostlyPositive ? firstNegative : firstPositive) +
                         " is inverted: it is oriented against the others");
    }
}

}  // namespace

template <int Dim>
double cellMeasure(const Points<Dim>& points, const Cell<Dim>& cell) {
    Mat<Dim> edges;
    for (int k = 0; k < Dim; ++k) edges.col(k) = points.col(cell[k + 1]) - points.col(cell[0]);
    return edges.determinant() / factorial(Dim);
}

template <int Dim>
double boundingBoxDiagonal(const Points<Dim>& points) {
    if (points.cols() == 0) return 0;
    return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// Returns facets in the order of the cells. They are chained at the vertex with the fewest cells, so that
/// lookups are short even at the hub of a fan: in the plane at most Σ min(deg i, deg j) steps over the edges,
/// which is linear for planar graphs (Chiba, Nishizeki 1985).
template <int Dim>
std::vector<Facet<Dim>> facetsOf(const SimplicialMesh<Dim>& mesh) {
    const std::vector<int> degree = cellsPerVertex(mesh);
    std::vector<int> latest(degree.size(), -1), before;
    std::vector<std::array<int, Dim>> keys;
    std::vector<Facet<Dim>> facets;
    facets.reserve(mesh.cells.size() * (Dim + 1) / 2 + 1);
    for (int c = 0; c < mesh.cellCount(); ++c) {
        for (int k = 0; k <= Dim; ++k) {
            const auto vertices = oppositeFacet<Dim>(mesh.cells[c], k);
            const auto key = sorted(vertices);
            int& chain = latest[*std::min_element(key.begin(), key.end(),
                                                  [&](int a, int b) { return degree[a] < degree[b]; })];
            int known = chain;
            while (known >= 0 && keys[known] != key) known = before[known];
            if (known < 0) {
                before.push_back(std::exchange(chain, static_cast<int>(facets.size())));
                keys.push_back(key);
                facets.push_back({vertices, {c, -1}});
                continue;
            }
            auto& facet = facets[known];
            if (facet.interior())
                throw InputError("cells " + std::to_string(facet.cells[0]) + ", " +
                                 std::to_string(facet.cells[1]) + " and " + std::to_string(c) +
                                 " share one " + (Dim == 2 ? "edge" : "face"));
            facet.cells[1] = c;
        }
    }
    return facets;
}

template <int Dim>
void requireValid(const SimplicialMesh<Dim>& mesh) {
    if (mesh.cells.empty())
        throw InputError(Dim == 2 ? "the mesh has no triangle" : "the mesh has no tetrahedron");
    requireFinite(mesh);
    requireIndices(mesh);
    requireNoDuplicates(mesh);
    requireOneOrientation(mesh);
    facetsOf(mesh);
}

#define WEND_INSTANTIATE(Dim)                                               \
    template double cellMeasure<Dim>(const Points<Dim>&, const Cell<Dim>&); \
    template double boundingBoxDiagonal<Dim>(const Points<Dim>&);           \
    template std::vector<Facet<Dim>> facetsOf(const SimplicialMesh<Dim>&);  \
    template void requireValid(const SimplicialMesh<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
