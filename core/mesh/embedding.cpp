#include "core/mesh/embedding.h"

#include <Eigen/LU>
#include <limits>

namespace wend {
namespace {

/// Barycentric coordinates of p in a cell, whether it lies inside or not.
template <int Dim>
Location<Dim> coordinates(const SimplicialMesh<Dim>& mesh, int cell, const Vec<Dim>& p) {
    const auto& ids = mesh.cells[cell];
    Mat<Dim> edges;
    for (int k = 0; k < Dim; ++k) edges.col(k) = mesh.points.col(ids[k + 1]) - mesh.points.col(ids[0]);
    Location<Dim> location{cell, {}};
    location.weights.template tail<Dim>() = edges.inverse() * (p - mesh.points.col(ids[0]));
    location.weights[0] = 1 - location.weights.template tail<Dim>().sum();
    return location;
}

/// One of the cell's own vertices.
template <int Dim>
Location<Dim> atVertex(const SimplicialMesh<Dim>& mesh, int cell, int vertex) {
    Location<Dim> location{cell, {}};
    for (int k = 0; k <= Dim; ++k) location.weights[k] = mesh.cells[cell][k] == vertex ? 1 : 0;
    return location;
}

/// The nearest of the vertices that cells have.
template <int Dim>
int nearestUsed(const SimplicialMesh<Dim>& mesh, const std::vector<int>& offsets, const Vec<Dim>& p) {
    int best = -1;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (offsets[v] == offsets[v + 1]) continue;
        if (best < 0 || (mesh.points.col(v) - p).squaredNorm() < (mesh.points.col(best) - p).squaredNorm())
            best = v;
    }
    return best;
}

/// Cells at each vertex, as one list with offsets.
template <int Dim>
std::pair<std::vector<int>, std::vector<int>> cellsOfVertices(const SimplicialMesh<Dim>& mesh) {
    std::vector<int> offsets(static_cast<std::size_t>(mesh.vertexCount()) + 1, 0);
    for (const auto& cell : mesh.cells)
        for (int v : cell) ++offsets[v + 1];
    for (std::size_t v = 1; v < offsets.size(); ++v) offsets[v] += offsets[v - 1];
    std::vector<int> list(static_cast<std::size_t>(offsets.back())), at(offsets.begin(), offsets.end() - 1);
    for (int c = 0; c < mesh.cellCount(); ++c)
        for (int v : mesh.cells[c]) list[at[v]++] = c;
    return {std::move(offsets), std::move(list)};
}

}  // namespace

template <int Dim>
Embedding<Dim>::Embedding(const SimplicialMesh<Dim>& rest, const Points<Dim>& points) {
    const PointLocator<Dim> locator(rest.points, rest.cells);
    const auto [offsets, cells] = cellsOfVertices(rest);
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Vec<Dim> p = points.col(i);
        int nearest = locator.nearestVertex(p);
        if (rest.points.col(nearest) == p && offsets[nearest] < offsets[nearest + 1]) {
            m_locations.push_back(atVertex(rest, cells[offsets[nearest]], nearest));
            continue;
        }
        if (const auto inside = locator.find(p)) {
            m_locations.push_back(*inside);
            continue;
        }
        ++m_outside;
        if (offsets[nearest] == offsets[nearest + 1]) nearest = nearestUsed(rest, offsets, p);
        Location<Dim> best;
        double bestWeight = -std::numeric_limits<double>::infinity();
        for (int k = offsets[nearest]; k < offsets[nearest + 1]; ++k) {
            const auto location = coordinates(rest, cells[k], p);
            if (location.weights.minCoeff() <= bestWeight) continue;
            bestWeight = location.weights.minCoeff();
            best = location;
        }
        m_locations.push_back(best);
    }
}

template <int Dim>
Points<Dim> Embedding<Dim>::carry(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) const {
    Points<Dim> carried = Points<Dim>::Zero(Dim, static_cast<Eigen::Index>(m_locations.size()));
    for (std::size_t i = 0; i < m_locations.size(); ++i)
        for (int k = 0; k <= Dim; ++k)
            carried.col(static_cast<Eigen::Index>(i)) +=
                m_locations[i].weights[k] * pose.col(rest.cells[m_locations[i].cell][k]);
    return carried;
}

template class Embedding<2>;
template class Embedding<3>;

}  // namespace wend
