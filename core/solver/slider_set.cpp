#include "core/solver/slider_set.h"

#include <algorithm>
#include <map>

#include "core/mesh/decompositions.h"

namespace wend {
namespace {

constexpr double kOneDirection = 1e-9;  // sine of the angle below which two directions count as one

/// Completes a vertex from its directions.
template <int Dim>
void completeRows(typename SliderSet<Dim>::Vertex& vertex) {
    const auto count = static_cast<Eigen::Index>(vertex.rows.size());
    Eigen::MatrixXd C(count, Dim);
    for (Eigen::Index j = 0; j < count; ++j)
        C.row(j) = vertex.rows[static_cast<std::size_t>(j)].direction.transpose();
    const Eigen::MatrixXd inverse = pseudoInverse(C, kOneDirection);
    for (Eigen::Index j = 0; j < count; ++j) vertex.rows[static_cast<std::size_t>(j)].column = inverse.col(j);
    vertex.projector = inverse.lazyProduct(C);
    if (!vertex.isAlongAxes) return;
    vertex.projector.setZero();
    for (int k = 0; k < Dim; ++k) vertex.projector(k, k) = vertex.held >> k & 1U;
}

}  // namespace

/// Groups the sliders by vertex, and computes the projector onto the directions in which each is held.
template <int Dim>
SliderSet<Dim>::SliderSet(const Sliders& sliders) : m_count(static_cast<Eigen::Index>(sliders.size())) {
    std::map<int, Vertex> byVertex;
    for (Eigen::Index i = 0; i < m_count; ++i) {
        const Slider& slider = sliders[static_cast<std::size_t>(i)];
        Vertex& own = byVertex[slider.vertex];
        own.vertex = slider.vertex;
        if (slider.hasNormal()) {
            own.isAlongAxes = false;
            own.rows.push_back({i, slider.normal.template head<Dim>(), {}, slider.isGuided});
            continue;
        }
        own.held |= slider.held;
        for (int k = 0; k < Dim; ++k)
            if (slider.held >> k & 1U) own.rows.push_back({i, Vec<Dim>::Unit(k), {}, false});
    }
    for (auto& [id, vertex] : byVertex) {
        completeRows<Dim>(vertex);
        m_vertices.push_back(std::move(vertex));
    }
}

template <int Dim>
bool SliderSet<Dim>::areAlongAxes() const {
    return std::ranges::all_of(m_vertices, &Vertex::isAlongAxes);
}

template <int Dim>
bool SliderSet<Dim>::areGuided() const {
    return std::ranges::any_of(
        m_vertices, [](const Vertex& one) { return std::ranges::any_of(one.rows, &Vertex::Row::isGuided); });
}

template <int Dim>
void SliderSet<Dim>::erase(const std::vector<int>& vertices) {
    std::erase_if(m_vertices,
                  [&](const Vertex& one) { return std::ranges::binary_search(vertices, one.vertex); });
}

template <int Dim>
void SliderSet<Dim>::turn(const Points<Dim>& directions) {
    for (Vertex& vertex : m_vertices) {
        bool isGuided = false;
        for (auto& row : vertex.rows) {
            if (!row.isGuided) continue;
            row.direction = directions.col(row.slider);
            isGuided = true;
        }
        if (isGuided) completeRows<Dim>(vertex);
    }
}

template <int Dim>
Vec<Dim> SliderSet<Dim>::Vertex::valueOf(const Points<Dim>& prescribed, Eigen::Index first) const {
    Vec<Dim> value = Vec<Dim>::Zero();
    if (isAlongAxes) {
        for (const Row& row : rows)
            for (int k = 0; k < Dim; ++k)
                if (row.direction[k] != 0) value[k] = prescribed(k, first + row.slider);
        return value;
    }
    for (const Row& row : rows) value += row.column * row.direction.dot(prescribed.col(first + row.slider));
    return value;
}

template <int Dim>
void SliderSet<Dim>::Vertex::place(const Points<Dim>& targets, Eigen::Index first,
                                   Eigen::Ref<Vec<Dim>> p) const {
    if (isAlongAxes) {
        for (const Row& row : rows)
            for (int k = 0; k < Dim; ++k)
                if (row.direction[k] != 0) p[k] = targets(k, first + row.slider);
        return;
    }
    Vec<Dim> correction = Vec<Dim>::Zero();
    for (const Row& row : rows)
        if (!row.isGuided) correction += row.column * row.direction.dot(targets.col(first + row.slider) - p);
    p += correction;
}

template class SliderSet<2>;
template class SliderSet<3>;

}  // namespace wend
