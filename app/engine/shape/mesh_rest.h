#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// Returns the rest mesh of a file's mesh, in which parts that touch vertex to vertex are connected.
/// `notices` receives what the user should know about vertices that were joined, or that no cell uses;
/// `carried` are those that cells of the file use all the same.
template <int Dim>
std::shared_ptr<const SimplicialMesh<Dim>> joinedRest(const SimplicialMesh<Dim>& mesh,
                                                      std::vector<Message>& notices,
                                                      const std::vector<int>& carried = {});

/// Returns a notice about parts that are connected by a single vertex or edge; empty if there are none.
template <int Dim>
Message hangingNotice(const SimplicialMesh<Dim>& rest);

/// Tells it.
template <int Dim>
void tellOfHanging(const SimplicialMesh<Dim>& rest, std::vector<Message>& notices);

}  // namespace wend
