#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace wend {

/// One constrained point of the shape, Σ_k weight_k · v_{vertex_k} = prescribed velocity: a vertex has one
/// term of weight 1, a point in a cell its barycentric coordinates.
struct ConstraintRow {
    std::vector<std::pair<int, double>> terms;
};

/// A vertex that is held in some directions, and slides across them: along `normal` (of length 1; in the
/// plane its third coordinate is 0) if that is not zero, else in the coordinates whose bits are set in
/// `held`. In these directions its velocity is prescribed. A vertex may have several. Where a row makes it a
/// pivot, the row counts. A guided one has another normal at every shape, see
/// VelocitySolver::setDirections().
struct Slider {
    int vertex = -1;
    unsigned held = 0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    bool isGuided = false;

    bool hasNormal() const { return !normal.isZero(0); }
    bool operator==(const Slider&) const = default;
};
using Sliders = std::vector<Slider>;

/// Returns the same rows with one term per vertex, none of weight 0, by vertex. Weights of one vertex are
/// added up; a row whose weights cancel has no terms.
std::vector<ConstraintRow> simplified(const std::vector<ConstraintRow>& rows);

/// A row that depends linearly on others: row = Σ coefficient · row_other. Its prescribed value must be the
/// same combination of the others' values, else the constraints contradict each other.
struct DependentRow {
    int row = -1;
    std::vector<std::pair<int, double>> combination;  // of rows that are not dependent themselves
};

/// The rows in reduced row echelon form. Every pivot vertex is known from the prescribed values and the free
/// vertices:
///   v_pivot = Σ values.second · prescribed_{values.first} − Σ free.second · v_{free.first}.
struct Elimination {
    /// A vertex whose velocity follows from the prescribed values and from free vertices.
    struct Pivot {
        int vertex = -1;
        int row = -1;  // the row that it was found in
        std::vector<std::pair<int, double>> values;
        std::vector<std::pair<int, double>> free;
    };
    std::vector<Pivot> pivots;
    std::vector<DependentRow> dependent;
};

/// Eliminates simplified rows: those of one vertex first, then the others in their order, each with the
/// vertex of its largest remaining weight as pivot, if possible one that does not slide. Every row becomes
/// either a pivot or a dependent row. Weights below 1e-10 count as 0, so rows are to have weights of the
/// order of 1. Of equal largest weights the vertex of the lowest number is the pivot. No row gives no pivots.
Elimination eliminate(const std::vector<ConstraintRow>& rows, const Sliders& sliders = {});

/// Returns those of any rows that depend linearly on others. Which rows of a dependent set are named follows
/// from the order of eliminate().
std::vector<DependentRow> dependentRows(const std::vector<ConstraintRow>& rows);

}  // namespace wend
