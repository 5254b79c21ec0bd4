#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "core/solver/slider_set.h"

namespace wend {

/// Returns the number of the facet-connected component of every cell. Parts that only touch at a vertex can
/// turn about it. Components are numbered from 0 in the order of their first cells. Time is about linear in
/// the facets.
template <int Dim>
std::vector<int> cellComponents(const SimplicialMesh<Dim>& mesh);

/// Returns for every component whether its constrained points leave no rigid motion free, and at φ_CONF no
/// similarity: two distinct points in 2D, three that are not on a line in 3D. A point counts for the
/// component that has all its vertices. Vertices that slide count by the coordinates in which they are held.
/// Components that the mesh's welds connect hold one another. Points nearer to each other than 1e-6 of the
/// shape's size count as one, and angles likewise. Component i is that of the cells c with components[c] = i.
template <int Dim>
std::vector<bool> wellConstrained(const SimplicialMesh<Dim>& mesh, const std::vector<int>& components,
                                  const std::vector<ConstraintRow>& rows, const SliderSet<Dim>& sliders = {});

/// Vertices that only move together: those of components that welds connect, of which no constraint leaves
/// less than a rigid motion free, and the rows of theirs.
struct LooseGroup {
    std::vector<int> vertices, rows;
};
/// Returns the groups of components that are not `held` (see wellConstrained()) and have rows, but no
/// sliders.
template <int Dim>
std::vector<LooseGroup> looseGroups(const SimplicialMesh<Dim>& mesh, const std::vector<int>& components,
                                    const std::vector<bool>& held, const std::vector<ConstraintRow>& rows,
                                    const SliderSet<Dim>& sliders = {});

}  // namespace wend
