#include "core/motion/handle_points.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number_text.h"
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
      m_standsFor(standsFor(rest)) {
    std::vector<MeshPart> ranges = rest.parts;
    if (ranges.empty()) ranges.push_back({"", 0, rest.vertexCount(), 0, rest.cellCount()});
    for (auto range = ranges.rbegin(); range != ranges.rend(); ++range)
        m_parts.push_back(std::make_unique<const Part>(rest, *range));
}

template <int Dim>
HandlePlacer<Dim>::Part::Part(const SimplicialMesh<Dim>& rest, const MeshPart& own)
    : range(own),
      cells(rest.cells.begin() + own.firstCell, rest.cells.begin() + own.endCell),
      locator(rest.points, cells) {}

template <int Dim>
auto HandlePlacer<Dim>::partsFor(const std::string& name) const -> Parts {
    if (name.empty()) return m_parts;
    const auto found =
        std::ranges::find_if(m_parts, [&](const auto& part) { return part->range.name == name; });
    if (found == m_parts.end()) throw InputError("there is no part \"" + name + "\"");
    return {&*found, 1};
}

template <int Dim>
std::vector<ConstrainedPoint> HandlePlacer<Dim>::place(const Handle<Dim>& handle, int number) const {
    const Parts parts = partsFor(handle.part);
    std::vector<Terms> all =
        std::visit([&](const auto& given) { return this->termsOf(given, parts); }, handle.at);
    if (all.empty()) throw InputError("it has no points");
    std::vector<ConstrainedPoint> points;
    std::vector<Terms> seen;  // sorted
    for (Terms& terms : all) {
        const auto place = std::lower_bound(seen.begin(), seen.end(), terms);
        if (place != seen.end() && *place == terms) continue;
        seen.insert(place, terms);
        points.push_back({number, std::move(terms)});
    }
    return points;
}

/// Returns the terms of vertices, which are numbered within the named part.
template <int Dim>
auto HandlePlacer<Dim>::termsOf(const std::vector<int>& vertices, const Parts& parts) const
    -> std::vector<Terms> {
    const bool isOne = parts.size() == 1;
    const int first = isOne ? parts.front()->range.firstVertex : 0,
              end = isOne ? parts.front()->range.endVertex : m_rest.vertexCount();
    std::vector<Terms> result;
    for (const int v : vertices) {
        if (v < 0 || v >= end - first) {
            throw InputError("vertex " + std::to_string(v) +
                             " is out of range, the shape has vertices 0 to " +
                             std::to_string(end - first - 1));
        }
        if (m_standsFor[first + v] < 0)
            throw InputError({sentence("Core", "vertex %1 belongs to no cell"), v});
        result.push_back({{m_standsFor[first + v], 1.0}});
    }
    return result;
}

/// Returns the terms of points, each in the first of the parts that contains it.
template <int Dim>
auto HandlePlacer<Dim>::termsOf(const std::vector<Vec<Dim>>& points, const Parts& parts) const
    -> std::vector<Terms> {
    std::vector<Terms> result;
    result.reserve(points.size());
    for (const Vec<Dim>& p : points) {
        Terms terms;
        for (std::size_t i = 0; i < parts.size() && terms.empty(); ++i) terms = termsIn(*parts[i], p);
        if (terms.empty())
            throw InputError("point " + placeName<Dim>(m_units.domain(p)) + " lies outside the " +
                             (parts.size() == 1 && !parts.front()->range.name.empty() ? "part" : "shape"));
        result.push_back(std::move(terms));
    }
    return result;
}

/// Returns the vertices inside a region, in the first of the parts that has any.
template <int Dim>
auto HandlePlacer<Dim>::termsOf(const Region<Dim>& region, const Parts& parts) const -> std::vector<Terms> {
    std::vector<Terms> result;
    for (std::size_t i = 0; i < parts.size() && result.empty(); ++i)
        for (int v = parts[i]->range.firstVertex; v < parts[i]->range.endVertex; ++v)
            if (m_standsFor[v] == v &&
                signedDistance<Dim>(region, m_rest.points.col(v)) <= kRegionBoundary * m_size)
                result.push_back({{v, 1.0}});
    if (result.empty()) throw InputError(sentence("Core", "its region holds no vertex"));
    return result;
}

/// Returns nothing for a point outside.
template <int Dim>
auto HandlePlacer<Dim>::termsIn(const Part& part, const Vec<Dim>& p) const -> Terms {
    const int nearest = part.locator.nearestVertex(p);
    if (nearest >= 0 && (m_rest.points.col(nearest) - p).norm() <= kSameVertex * m_size)
        return {{nearest, 1.0}};
    const auto location = part.locator.find(p, kOutside);
    if (!location) return {};
    Terms terms;
    double sum = 0;
    for (int k = 0; k <= Dim; ++k) {
        const double weight = location->weights[k];
        if (std::abs(weight) <= kNoWeight) continue;
        terms.emplace_back(part.cells[location->cell][k], weight);
        sum += weight;
    }
    for (auto& term : terms) term.second /= sum;
    std::sort(terms.begin(), terms.end());
    return terms;
}

template class HandlePlacer<2>;
template class HandlePlacer<3>;

}  // namespace wend
