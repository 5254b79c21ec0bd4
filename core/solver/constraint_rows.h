#pragma once

#include <utility>
#include <vector>

namespace wend {

/// Σ_k weight_k · v_{vertex_k} = prescribed velocity: one constrained point of the shape (a vertex: one term
/// of weight 1; a point in a cell: its barycentric coordinates).
struct ConstraintRow {
    std::vector<std::pair<int, double>> terms;
};

/// Vertices that are held in some coordinates, and slide along the others: bit k stands for coordinate k, in
/// which the velocity is 0. Where a row makes a vertex a pivot, the row counts.
using Sliders = std::vector<std::pair<int, unsigned>>;

/// The same rows with one term per vertex, none of weight 0, by vertex.
std::vector<ConstraintRow> simplified(const std::vector<ConstraintRow>& rows);

/// A row that says nothing new: row = Σ coefficient · row_other. Its prescribed value must be the same
/// combination of the others' values, else the constraints contradict each other.
struct DependentRow {
    int row = -1;
    std::vector<std::pair<int, double>> combination;  // of rows that are not dependent themselves
};

/// The rows in reduced row echelon form. Every pivot vertex is known from the prescribed values and the free
/// vertices:
///   v_pivot = Σ values.second · prescribed_{values.first} − Σ free.second · v_{free.first}.
struct Elimination {
    struct Pivot {
        int vertex = -1;
        int row = -1;  // the row that it was found in
        std::vector<std::pair<int, double>> values;
        std::vector<std::pair<int, double>> free;
    };
    std::vector<Pivot> pivots;
    std::vector<DependentRow> dependent;
};

/// Simplified rows: those of one vertex first, then the others in their order, each with the vertex of its
/// largest remaining weight as pivot, one that does not slide if there is any.
Elimination eliminate(const std::vector<ConstraintRow>& rows, const Sliders& sliders = {});

/// The rows (any) that depend linearly on others.
std::vector<DependentRow> dependentRows(const std::vector<ConstraintRow>& rows);

}  // namespace wend
