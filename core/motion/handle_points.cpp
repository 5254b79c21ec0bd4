#include "core/motion/handle_points.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/error.h"
#include "core/mesh/number_text.h"
#include "core/mesh/shape_size.h"
#include "core/mesh/used_vertices.h"

namespace wend {

namespace {

// Relative to the size: a point this near to a vertex is the vertex; a vertex this near to a region is
// inside.
constexpr double kSameVertex = 1e-12;
constexpr double kRegionBoundary = 1e-9;
// Barycentric tolerance: points drawn on the outline are outside by rounding.
constexpr double kOutside = 1e-9;
// Weights below are rounding: the point is on the opposite facet.
constexpr double kNoWeight = 1e-12;

template <int Dim>
std::vector<int> standsFor(const SimplicialMesh<Dim>& mesh) {
    const std::vector<bool> used = usedVertices<Dim>(mesh.vertexCount(), mesh.cells);
    std::vector<int> result(used.size(), -1);
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (used[v]) result[v] = v;
    for (const Twin& twin : twinsOf<Dim>(mesh)) result[twin.vertex] = twin.of;
    return result;
}

}  // namespace

template <int Dim>
HandlePlacer<Dim>::HandlePlacer(const SimplicialMesh<Dim>& rest, const Normalization<Dim>& units)
    : m_rest(rest),
      m_units(units),
      m_size(shapeSize<Dim>(rest.points, rest.cells).size),
      m_standsFor(standsFor(rest)),
      m_locator(rest.points, rest.cells) {}

template <int Dim>
std::vector<ConstrainedPoint> HandlePlacer<Dim>::place(const Placement<Dim>& at, int handle) const {
    std::vector<Terms> all = std::visit([this](const auto& given) { return this->termsOf(given); }, at);
    if (all.empty()) throw InputError("it has no points");
    std::vector<ConstrainedPoint> points;
    std::vector<Terms> seen;  // sorted
    for (Terms& terms : all) {
        const auto place = std::lower_bound(seen.begin(), seen.end(), terms);
        if (place != seen.end() && *place == terms) continue;
        seen.insert(place, terms);
        points.push_back({handle, std::move(terms)});
    }
    return points;
}

template <int Dim>
auto HandlePlacer<Dim>::termsOf(const std::vector<int>& vertices) const -> std::vector<Terms> {
    std::vector<Terms> result;
    for (const int v : vertices) {
        if (v < 0 || v >= m_rest.vertexCount()) {
            throw InputError("vertex " + std::to_string(v) +
                             " is out of range, the shape has vertices 0 to " +
                             std::to_string(m_rest.vertexCount() - 1));
        }
        if (m_standsFor[v] < 0) throw InputError("vertex " + std::to_string(v) + " belongs to no cell");
        result.push_back({{m_standsFor[v], 1.0}});
    }
    return result;
}

template <int Dim>
auto HandlePlacer<Dim>::termsOf(const std::vector<Vec<Dim>>& points) const -> std::vector<Terms> {
    std::vector<Terms> result;
    result.reserve(points.size());
    for (const Vec<Dim>& p : points) result.push_back(termsOf(p));
    return result;
}

template <int Dim>
auto HandlePlacer<Dim>::termsOf(const Region<Dim>& region) const -> std::vector<Terms> {
    std::vector<Terms> result;
    for (int v = 0; v < m_rest.vertexCount(); ++v) {
        if (m_standsFor[v] == v &&
            signedDistance<Dim>(region, m_rest.points.col(v)) <= kRegionBoundary * m_size)
            result.push_back({{v, 1.0}});
    }
    if (result.empty()) throw InputError("its region holds no vertex");
    return result;
}

template <int Dim>
auto HandlePlacer<Dim>::termsOf(const Vec<Dim>& p) const -> Terms {
    const int nearest = m_locator.nearestVertex(p);
    if (nearest >= 0 && (m_rest.points.col(nearest) - p).norm() <= kSameVertex * m_size)
        return {{nearest, 1.0}};
    const auto location = m_locator.find(p, kOutside);
    if (!location) throw InputError("point " + placeName<Dim>(m_units.domain(p)) + " lies outside the shape");
    Terms terms;
    double sum = 0;
    for (int k = 0; k <= Dim; ++k) {
        const double weight = location->weights[k];
        if (std::abs(weight) <= kNoWeight) continue;
        terms.emplace_back(m_rest.cells[location->cell][k], weight);
        sum += weight;
    }
    for (auto& term : terms) term.second /= sum;
    std::sort(terms.begin(), terms.end());
    return terms;
}

template class HandlePlacer<2>;
template class HandlePlacer<3>;

}  // namespace wend
