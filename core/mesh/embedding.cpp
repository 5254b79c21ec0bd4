#include "core/mesh/embedding.h"

#include <limits>
#include <string>

#include "core/mesh/cell_geometry.h"
#include "core/mesh/error.h"

namespace wend {
namespace {

/// One of the cell's own vertices.
template <int Dim>
Location<Dim> atVertex(const SimplicialMesh<Dim>& mesh, int cell, int vertex) {
    Location<Dim> location{cell, {}};
    for (int k = 0; k <= Dim; ++k) location.weights[k] = mesh.cells[cell][k] == vertex ? 1 : 0;
    return location;
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
        const int nearest = locator.nearestVertex(p);
        if (nearest < 0 || rest.cells.empty())
            throw InputError("point " + std::to_string(i) + " has no place in the shape");
        if (rest.points.col(nearest) == p) {
            m_locations.push_back(atVertex(rest, cells[offsets[nearest]], nearest));
            continue;
        }
        if (const auto inside = locator.find(p)) {
            m_locations.push_back(*inside);
            continue;
        }
        ++m_outside;
        Location<Dim> best;
        double bestWeight = -std::numeric_limits<double>::infinity();
        for (int k = offsets[nearest]; k < offsets[nearest + 1]; ++k) {
            const Location<Dim> location{cells[k], barycentric<Dim>(rest.points, rest.cells[cells[k]], p)};
            if (location.weights.minCoeff() <= bestWeight) continue;
            bestWeight = location.weights.minCoeff();
            best = location;
        }
        m_locations.push_back(best);
    }
}

template <int Dim>
Points<Dim> Embedding<Dim>::carry(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) const {
    Points<Dim> carried(Dim, static_cast<Eigen::Index>(m_locations.size()));
    for (std::size_t i = 0; i < m_locations.size(); ++i) {
        const Cell<Dim>& cell = rest.cells[m_locations[i].cell];
        Vec<Dim> p = Vec<Dim>::Zero();
        for (int k = 0; k <= Dim; ++k) p += m_locations[i].weights[k] * pose.col(cell[k]);
        carried.col(static_cast<Eigen::Index>(i)) = p;
    }
    return carried;
}

template class Embedding<2>;
template class Embedding<3>;

}  // namespace wend
