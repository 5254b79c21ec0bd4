#pragma once

#include <array>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns whether a cell's measure is at most 1e-14 of that of a cube on its longest edge, where rounding
/// determines the orientation. A cell whose vertices coincide is flat.
template <int Dim>
bool isFlat(const Points<Dim>& points, const Cell<Dim>& cell);

/// The measure, the smallest angle and the radius–edge ratio of one cell.
struct CellQuality {
    double measure = 0;   // signed area or volume
    double minAngle = 0;  // radians; 2D: the smallest interior angle, 3D: the smallest dihedral angle
    double radiusEdgeRatio =
        0;  // circumradius / shortest edge: 0.577 (2D) or 0.612 (3D) at best, ∞ for a flat cell
};

/// Computes the quality of one cell. Angles between facets j and k are π − ∠(n_j, n_k) with the outward
/// normals n, and the circumcentre c relative to corner 0 solves 2 e_k · c = |e_k|² for the edges e_k. A cell
/// of measure 0 has the angle 0 and the ratio ∞.
template <int Dim>
CellQuality cellQuality(const Points<Dim>& points, const Cell<Dim>& cell);

/// Summarizes the quality of all cells. Measures are in the unit of the points to the power of the dimension,
/// angles in radians; the ratios are dimensionless.
struct QualitySummary {
    static constexpr int binCount = 15;
    static constexpr double binDegrees =
        5;  // bin i counts minimal angles in [5 i, 5 (i + 1)) degrees; 75 is never passed

    double minMeasure = 0, maxMeasure = 0, totalMeasure = 0;  // of absolute values
    double minAngle = 0, meanMinAngle = 0;                    // radians
    double maxRadiusEdgeRatio = 0;
    int worstCell = -1;  // the one of the smallest angle, the first of several; −1 if there is no cell
    std::array<int, binCount> angleHistogram{};

    double maxAngle = 0;              // radians, of all angles
    std::array<int, 36> allAngles{};  // all angles of all cells: bin i counts [5 i, 5 (i + 1)) degrees
    std::array<int, 12> ratios{};     // radius-edge ratios: bin i counts [0.5 + i / 4, 0.75 + i / 4), the
                                      // last one all above
    std::array<int, 16> measures{};   // bin i counts [2^(i − 8), 2^(i − 7)) times the mean, the first and
                                      // the last one all beyond
};

/// Computes the summary of a mesh. Values beyond the ends of a histogram count in its first or last bin;
/// cells of measure 0 count with a least angle of 0, but have no angles in `allAngles`. Without cells all is
/// 0, and the worst cell −1.
template <int Dim>
QualitySummary qualityOf(const SimplicialMesh<Dim>& mesh);

}  // namespace wend
