#pragma once

#include "core/assembly/back_end.h"

namespace wend {

/// The reference back end: plain C++ on the processor's cores.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeCpuBackEnd(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                             const SimplicialMesh<Dim>& rest, const Material<Dim>& material,
                                             int threads);

/// The threads that pay for a mesh: `wanted` (0: all cores), but one below about 10 000 unknowns.
int usefulThreads(int wanted, int unknowns);

}  // namespace wend
