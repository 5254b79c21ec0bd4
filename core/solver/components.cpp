#include "core/solver/components.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "core/base/disjoint_sets.h"
#include "core/mesh/decompositions.h"
#include "core/mesh/shape_size.h"
#include "core/solver/welded_components.h"

namespace wend {
namespace {

// Points nearer than this, relative to the size, count as one; angles likewise.
constexpr double kDistinct = 1e-6;

template <int Dim>
Vec<Dim> pointOf(const ConstraintRow& row, const Points<Dim>& points) {
    Vec<Dim> x = Vec<Dim>::Zero();
    for (const auto& [vertex, weight] : row.terms) x += weight * points.col(vertex);
    return x;
}

/// Returns whether the points span Dim − 1 dimensions: two distinct ones in 2D, three that are not on a line
/// in 3D. The scatter Σ (p − m)(p − m)ᵀ has the squared extents along its axes as singular values; all but
/// the least must exceed kDistinct of the size, squared.
template <int Dim>
bool spanEnough(const std::vector<Vec<Dim>>& points, double size) {
    if (points.size() < static_cast<std::size_t>(Dim)) return false;
    Mat<Dim> scatter = Mat<Dim>::Zero();
    Vec<Dim> mean = Vec<Dim>::Zero();
    for (const auto& p : points) mean += p / static_cast<double>(points.size());
    for (const auto& p : points) scatter += (p - mean) * (p - mean).transpose();
    const Vec<Dim> squares = singularValues<Dim>(scatter);
    return squares[Dim - 2] > kDistinct * kDistinct * size * size;
}

/// How much points that are held, in all coordinates or some, leave of the similarities: MᵀM, where a row of
/// M has one coordinate of the velocities at one point (SimilarityVelocities).
template <int Dim>
class HeldSimilarities {
  public:
    static constexpr int kModes = SimilarityVelocities<Dim>::ColsAtCompileTime;

    /// Adds p, relative to the middle of the shape and in terms of its size.
    void add(const Vec<Dim>& p, const Mat<Dim>& projector) {
        const SimilarityVelocities<Dim> velocities = similarityVelocities<Dim>(p);
        m_square += velocities.transpose() * projector * velocities;
    }
    const Mat<kModes>& square() const { return m_square; }
    /// Returns whether every eigenvalue of MᵀM exceeds the square of kDistinct.
    bool all() const {
        const Mat<kModes> shifted = m_square - kDistinct * kDistinct * Mat<kModes>::Identity();
        return Eigen::LLT<Mat<kModes>>(shifted).info() == Eigen::Success;
    }

  private:
    Mat<kModes> m_square = Mat<kModes>::Zero();
};

/// Returns the components of every vertex, ascending, each once. A vertex at which components touch has
/// several, one without cells has none.
template <int Dim>
std::vector<std::vector<int>> componentsOfVertices(const SimplicialMesh<Dim>& mesh,
                                                   const std::vector<int>& components) {
    std::vector<std::vector<int>> result(mesh.vertexCount());
    for (int c = 0; c < mesh.cellCount(); ++c)
        for (int v : mesh.cells[c]) {
            auto& list = result[v];
            const auto at = std::lower_bound(list.begin(), list.end(), components[c]);
            if (at == list.end() || *at != components[c]) list.insert(at, components[c]);
        }
    return result;
}

/// Returns the components that have all vertices of a row. A row across components holds none of them by
/// itself.
std::vector<int> componentsOfRow(const ConstraintRow& row, const std::vector<std::vector<int>>& ofVertex) {
    std::vector<int> common = ofVertex[row.terms.front().first];
    for (const auto& [vertex, weight] : row.terms)
        std::erase_if(common, [&, v = vertex](int c) {
            return !std::binary_search(ofVertex[v].begin(), ofVertex[v].end(), c);
        });
    return common;
}

/// Returns the components of a weld's two points; nothing if the vertices of one are of several.
std::optional<std::array<int, 2>> componentsOfWeld(const Weld& weld,
                                                   const std::vector<std::vector<int>>& ofVertex) {
    std::array<ConstraintRow, 2> sides;
    for (const auto& term : weld.terms) sides[term.second > 0 ? 0 : 1].terms.push_back(term);
    std::array<int, 2> result{};
    for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<int> common =
            sides[k].terms.empty() ? std::vector<int>() : componentsOfRow(sides[k], ofVertex);
        if (common.empty()) return std::nullopt;
        result[k] = common.front();
    }
    return result;
}

template <int Dim>
Vec<Dim> firstPointOf(const Weld& weld, const Points<Dim>& points) {
    Vec<Dim> x = Vec<Dim>::Zero();
    for (const auto& [vertex, weight] : weld.terms) x += std::max(weight, 0.0) * points.col(vertex);
    return x;
}

}  // namespace

template <int Dim>
std::vector<int> cellComponents(const SimplicialMesh<Dim>& mesh) {
    std::vector<int> parent(mesh.cells.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const auto& facet : facetsOf(mesh))
        if (facet.interior()) {
            const int a = root(facet.cells[0]), b = root(facet.cells[1]);
            parent[std::max(a, b)] = std::min(a, b);
        }
    std::vector<int> number(mesh.cells.size(), -1), result(mesh.cells.size());
    int count = 0;
    for (int c = 0; c < mesh.cellCount(); ++c) {
        int& component = number[root(c)];
        if (component < 0) component = count++;
        result[c] = component;
    }
    return result;
}

template <int Dim>
std::vector<bool> wellConstrained(const SimplicialMesh<Dim>& mesh, const std::vector<int>& components,
                                  const std::vector<ConstraintRow>& rows, const SliderSet<Dim>& sliders) {
    const int count = components.empty() ? 0 : *std::max_element(components.begin(), components.end()) + 1;
    const auto ofVertex = componentsOfVertices(mesh, components);
    std::vector<std::vector<Vec<Dim>>> points(count);
    for (const auto& row : rows)
        for (int component : componentsOfRow(row, ofVertex))
            points[component].push_back(pointOf<Dim>(row, mesh.points));
    const double size = shapeSize<Dim>(mesh.points, mesh.cells).size;
    std::vector<bool> result(count);
    for (int i = 0; i < count; ++i) result[i] = spanEnough<Dim>(points[i], size);
    // The rest is for shapes with sliders or welds: their similarities are counted coordinate by coordinate.
    if (sliders.empty() && mesh.welds.empty()) return result;
    const Vec<Dim> middle = mesh.points.rowwise().mean();
    std::vector<HeldSimilarities<Dim>> held(count);
    for (int i = 0; i < count; ++i)
        for (const Vec<Dim>& p : points[i]) held[i].add((p - middle) / size, Mat<Dim>::Identity());
    for (const auto& slider : sliders.vertices())
        for (int component : ofVertex[slider.vertex])
            held[component].add((mesh.points.col(slider.vertex) - middle) / size, slider.projector);
    for (int i = 0; i < count; ++i) result[i] = result[i] || held[i].all();
    std::vector<WeldedPoint<Dim>> welded;
    for (const Weld& weld : mesh.welds)
        if (const auto between = componentsOfWeld(weld, ofVertex))
            welded.push_back({*between, (firstPointOf<Dim>(weld, mesh.points) - middle) / size});
    std::vector<SimilaritySquare<Dim>> squares;
    for (const auto& one : held) squares.push_back(one.square());
    holdWelded<Dim>(squares, welded, kDistinct, result);
    return result;
}

template <int Dim>
std::vector<LooseGroup> looseGroups(const SimplicialMesh<Dim>& mesh, const std::vector<int>& components,
                                    const std::vector<bool>& held, const std::vector<ConstraintRow>& rows,
                                    const SliderSet<Dim>& sliders) {
    const auto ofVertex = componentsOfVertices(mesh, components);
    DisjointSets sets(static_cast<int>(held.size()));
    for (const Weld& weld : mesh.welds)
        if (const auto between = componentsOfWeld(weld, ofVertex)) sets.join((*between)[0], (*between)[1]);
    for (const std::vector<int>& shared : ofVertex)  // where parts touch at a vertex
        for (const int component : shared) sets.join(shared.front(), component);
    std::vector<LooseGroup> groups(held.size());
    std::vector<bool> isLoose(held.size(), true);
    for (std::size_t c = 0; c < held.size(); ++c)
        if (held[c]) isLoose[static_cast<std::size_t>(sets.root(static_cast<int>(c)))] = false;
    for (const auto& slider : sliders.vertices())
        for (const int component : ofVertex[slider.vertex])
            isLoose[static_cast<std::size_t>(sets.root(component))] = false;
    const auto groupOf = [&](int vertex) {
        return static_cast<std::size_t>(sets.root(ofVertex[vertex].front()));
    };
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (!ofVertex[v].empty()) groups[groupOf(v)].vertices.push_back(v);
    for (int r = 0; r < static_cast<int>(rows.size()); ++r)
        if (const int vertex = rows[r].terms.front().first; !ofVertex[vertex].empty())
            groups[groupOf(vertex)].rows.push_back(r);
    std::vector<LooseGroup> loose;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (isLoose[g] && !groups[g].rows.empty()) loose.push_back(std::move(groups[g]));
    return loose;
}

#define WEND_INSTANTIATE(Dim)                                                                             \
    template std::vector<int> cellComponents(const SimplicialMesh<Dim>&);                                 \
    template std::vector<bool> wellConstrained(const SimplicialMesh<Dim>&, const std::vector<int>&,       \
                                               const std::vector<ConstraintRow>&, const SliderSet<Dim>&); \
    template std::vector<LooseGroup> looseGroups(const SimplicialMesh<Dim>&, const std::vector<int>&,     \
                                                 const std::vector<bool>&,                                \
                                                 const std::vector<ConstraintRow>&, const SliderSet<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
