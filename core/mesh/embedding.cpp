#include "core/mesh/embedding.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "core/base/error.h"
#include "core/mesh/triangle_tree.h"

namespace wend {
namespace {

/// Returns one of the cell's own vertices as a location.
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

/// Returns the gradients of the cell's hat functions, one column per vertex.
template <int Dim>
Eigen::Matrix<double, Dim, Dim + 1> hatGradients(const Points<Dim>& points, const Cell<Dim>& cell) {
    Mat<Dim> edges;
    for (int k = 0; k < Dim; ++k) edges.col(k) = points.col(cell[k + 1]) - points.col(cell[0]);
    Eigen::Matrix<double, Dim, Dim + 1> gradients;
    gradients.template rightCols<Dim>() = edges.inverse().transpose();
    gradients.col(0) = -gradients.template rightCols<Dim>().rowwise().sum();
    return gradients;
}

}  // namespace

/// The boundary of the partition, and the weights of points outside it.
template <int Dim>
class Embedding<Dim>::Outside {
  public:
    explicit Outside(const SimplicialMesh<Dim>& rest) : m_rest(rest) {
        for (const auto& facet : facetsOf(rest)) {
            if (facet.interior()) continue;
            m_facets.push_back(asTriangle(facet.vertices));
            m_cells.push_back(facet.cells[0]);
        }
        m_tree = TriangleTree(inSpace(rest.points), m_facets);
        std::tie(m_offsets, m_around) = cellsOfVertices(rest);
    }

    /// Returns the cell that a point outside follows, and its weights from the nearest boundary point.
    std::pair<int, Row> place(int point, const Vec<Dim>& p) const {
        const TriangleTree::Nearest nearest = m_tree.nearest(inSpace(p));
        std::map<int, double> weights;
        for (int k = 0; k < 3; ++k) {
            if (nearest.weights[k] == 0) continue;
            const int vertex = m_facets[nearest.triangle][k];
            weights[vertex] += nearest.weights[k];
            addGradient(vertex, nearest.weights[k] * (p - m_rest.points.col(vertex)), weights);
        }
        return {m_cells[nearest.triangle], {point, {weights.begin(), weights.end()}}};
    }

  private:
    /// An edge is a triangle that names one of its corners twice.
    static std::array<int, 3> asTriangle(const std::array<int, Dim>& facet) {
        return {facet[0], facet[1], facet[Dim - 1]};
    }
    static Points3 inSpace(const Points<Dim>& points) {
        Points3 result = Points3::Zero(3, points.cols());
        result.template topRows<Dim>() = points;
        return result;
    }

    /// Adds the weights of G · offset with the mean gradient G = Σ_c V_c F_c / Σ_c V_c at a vertex. With F_c
    /// = Σ_k x_k g_kᵀ, corner k of cell c has the weight V_c / Σ V · (g_k · offset).
    void addGradient(int vertex, const Vec<Dim>& offset, std::map<int, double>& weights) const {
        double volume = 0;
        for (int i = m_offsets[vertex]; i < m_offsets[vertex + 1]; ++i)
            volume += std::abs(cellMeasure<Dim>(m_rest.points, m_rest.cells[m_around[i]]));
        for (int i = m_offsets[vertex]; i < m_offsets[vertex + 1]; ++i) {
            const Cell<Dim>& cell = m_rest.cells[m_around[i]];
            const double part = std::abs(cellMeasure<Dim>(m_rest.points, cell)) / volume;
            const auto gradients = hatGradients<Dim>(m_rest.points, cell);
            for (int k = 0; k <= Dim; ++k) weights[cell[k]] += part * gradients.col(k).dot(offset);
        }
    }

    const SimplicialMesh<Dim>& m_rest;
    std::vector<std::array<int, 3>> m_facets;
    std::vector<int> m_cells;  // behind them
    TriangleTree m_tree;
    std::vector<int> m_offsets, m_around;  // cells at the vertices
};

/// Locates every point. Points outside all cells get a row of weights from their nearest boundary point and
/// the deformation gradient there.
template <int Dim>
Embedding<Dim>::Embedding(const SimplicialMesh<Dim>& rest, const Points<Dim>& points) {
    const PointLocator<Dim> locator(rest.points, rest.cells);
    const auto [offsets, cells] = cellsOfVertices(rest);
    std::optional<Outside> outside;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Vec<Dim> p = points.col(i);
        const int nearest = locator.nearestVertex(p);
        if (nearest < 0 || rest.cells.empty())
            throw InputError("point " + std::to_string(i) + " has no place in the shape");
        if (rest.points.col(nearest) == p) {
            m_locations.push_back(atVertex(rest, cells[offsets[nearest]], nearest));
            continue;
        }
        m_isFree = true;
        if (const auto inside = locator.find(p)) {
            m_locations.push_back(*inside);
        } else {
            if (!outside) outside.emplace(rest);
            auto [cell, row] = outside->place(static_cast<int>(i), p);
            m_locations.push_back({cell, Eigen::Matrix<double, Dim + 1, 1>::Zero()});
            m_rows.push_back(std::move(row));
        }
    }
    m_remainders = points - interpolate(rest, rest.points);
    // Zero remainders are −0, because a coordinate of −0 must keep its sign.
    m_remainders = (m_remainders.array() == 0).select(-0.0, m_remainders);
}

template <int Dim>
Points<Dim> Embedding<Dim>::carry(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) const {
    return interpolate(rest, pose) + m_remainders;
}

template <int Dim>
Points<Dim> Embedding<Dim>::interpolate(const SimplicialMesh<Dim>& rest, const Points<Dim>& values) const {
    Points<Dim> carried(Dim, static_cast<Eigen::Index>(m_locations.size()));
    for (std::size_t i = 0; i < m_locations.size(); ++i) {
        const Cell<Dim>& cell = rest.cells[m_locations[i].cell];
        Vec<Dim> p = Vec<Dim>::Zero();
        for (int k = 0; k <= Dim; ++k) p += m_locations[i].weights[k] * values.col(cell[k]);
        carried.col(static_cast<Eigen::Index>(i)) = p;
    }
    for (const Row& row : m_rows)
        for (const auto& [vertex, weight] : row.weights)
            carried.col(row.point) += weight * values.col(vertex);
    return carried;
}

template <int Dim>
std::vector<std::pair<int, double>> Embedding<Dim>::weights(const SimplicialMesh<Dim>& rest,
                                                            int point) const {
    std::vector<std::pair<int, double>> weights;
    const Location<Dim>& location = m_locations[static_cast<std::size_t>(point)];
    for (int k = 0; k <= Dim; ++k)
        if (location.weights[k] != 0) weights.emplace_back(rest.cells[location.cell][k], location.weights[k]);
    const auto row = std::lower_bound(m_rows.begin(), m_rows.end(), point,
                                      [](const Row& r, int p) { return r.point < p; });
    if (row != m_rows.end() && row->point == point) weights = row->weights;
    return weights;
}

template class Embedding<2>;
template class Embedding<3>;

}  // namespace wend
