#pragma once

#include <string>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

template <int Dim>
struct Shape;

/// Factor of growth or shrinkage above which a cell counts as blown up.
inline constexpr double kBlownUp = 10;

/// A connected place of a pose where something is wrong.
template <int Dim>
struct PosePlace {
    std::vector<int> members;  // facets of the border, or cells, increasing
    int count = 0;             // pairs of these facets, or cells
    Vec<Dim> at;               // where the first pair meets, or the middle of the worst cell
    int worstCell = -1;
    double ratio = 1;  // size of the worst cell relative to rest
};

/// Faults of a pose. Crossing facets are counted if they have no common vertex and did not cross at rest.
/// Triangles and cells that share vertices form one place; outlines cross at points, and each is a place.
template <int Dim>
struct PoseFaults {
    Points<Dim> points;                        // of the border in the pose …
    std::vector<std::array<int, Dim>> border;  // … and its edges or triangles
    std::vector<PosePlace<Dim>> crossings;     // that with the most pairs first
    std::vector<PosePlace<Dim>> blown;         // that with the worst cell first

    int pairs() const;
    int cells() const;
};

/// Finds faults of the cells, and crossings of the cells' border or of the surface that a cage carries.
template <int Dim>
PoseFaults<Dim> faultsOf(const Shape<Dim>& shape, const Points<Dim>& pose);

/// Returns for example "the surface passes through itself in 2 places (143 pairs of triangles), first near
/// (x, y, z)"; empty if it does not.
template <int Dim>
std::string crossingText(const PoseFaults<Dim>& faults);
/// Returns for example "3 cells have grown or shrunk more than 10 times, the worst to 0.05 of its size near
/// (x, y, z)".
template <int Dim>
std::string blownText(const PoseFaults<Dim>& faults);

}  // namespace wend
