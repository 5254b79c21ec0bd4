#pragma once

#include <Eigen/Core>
#include <cmath>
#include <span>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "wend/mesh.h"

namespace wend {

/// Coordinates one after another are the columns of a matrix.
template <int Dim>
Eigen::Map<const Points<Dim>> columnsOf(std::span<const Coordinates<Dim>> points) {
    static_assert(sizeof(Coordinates<Dim>) == Dim * sizeof(double));
    return {points.empty() ? nullptr : points.front().data(), Dim, static_cast<Eigen::Index>(points.size())};
}

/// Does the reverse; the span is valid as long as the matrix.
template <int Dim>
std::span<const Coordinates<Dim>> spanOf(const Points<Dim>& points) {
    return {reinterpret_cast<const Coordinates<Dim>*>(points.data()),
            static_cast<std::size_t>(points.cols())};
}

template <int Dim>
std::vector<Coordinates<Dim>> coordinatesOf(const Points<Dim>& points) {
    const auto all = spanOf<Dim>(points);
    return {all.begin(), all.end()};
}

template <int Dim>
Vec<Dim> vecOf(const Coordinates<Dim>& p) {
    return Eigen::Map<const Vec<Dim>>(p.data());
}

template <int Dim>
std::vector<Vec<Dim>> vecsOf(std::span<const Coordinates<Dim>> points) {
    std::vector<Vec<Dim>> all;
    all.reserve(points.size());
    for (const Coordinates<Dim>& p : points) all.push_back(vecOf<Dim>(p));
    return all;
}

template <int Dim>
SimplicialMesh<Dim> meshOf(std::span<const Coordinates<Dim>> points,
                           std::span<const CellVertices<Dim>> cells) {
    return {columnsOf<Dim>(points), {cells.begin(), cells.end()}};
}

template <int Dim>
Mesh<Dim> meshOf(const SimplicialMesh<Dim>& mesh) {
    return {coordinatesOf<Dim>(mesh.points), mesh.cells};
}

/// Throws what the library documents in the place of what is being handled.
[[noreturn]] void rethrowDocumented();

/// Calls f; what it throws becomes what the library documents.
template <typename F>
decltype(auto) documented(F&& f) {
    try {
        return f();
    } catch (...) {
        rethrowDocumented();
    }
}

}  // namespace wend
