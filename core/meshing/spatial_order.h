#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Sorts the vertices from `first` on, and the cells by their centroids, along a Hilbert curve for memory
/// locality, without which assembly and products take twice as long on large meshes. Returns the new number
/// of every vertex, and in `cellOrder` which cell comes at each place. Vertices before `first` keep their
/// numbers. Takes O(n log n), and is the same in every run; parts and welds are not renumbered.
template <int Dim>
std::vector<int> sortSpatially(SimplicialMesh<Dim>& mesh, int first, std::vector<int>* cellOrder = nullptr);

}  // namespace wend
