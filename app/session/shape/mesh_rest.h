#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns the rest mesh of a file's mesh, with parts joined that touch vertex to vertex. Notices report
/// joined and unused vertices.
template <int Dim>
std::shared_ptr<const SimplicialMesh<Dim>> joinedRest(const SimplicialMesh<Dim>& mesh,
                                                      std::vector<std::string>& notices);

/// Returns a notice about parts that are connected by a single vertex or edge; empty if there are none.
template <int Dim>
std::string hangingNotice(const SimplicialMesh<Dim>& rest);

/// Tells it.
template <int Dim>
void tellOfHanging(const SimplicialMesh<Dim>& rest, std::vector<std::string>& notices);

}  // namespace wend
