#pragma once

#include "core/assembly/back_end.h"

namespace wend {

/// Makes the back end on the CPU: the isotropic one if B = I in every cell, else the general one.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeCpuBackEnd(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                             const SimplicialMesh<Dim>& rest, const Material<Dim>& material,
                                             int threads);

/// Makes the reference back end: plain C++ that reads like the formulas, for any material.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeGeneralBackEnd(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                                 const SimplicialMesh<Dim>& rest,
                                                 const Material<Dim>& material, int threads);

/// Returns how many threads pay for a mesh: `wanted` (0: all cores), but one below about 10 000 unknowns.
/// Below that, handing work over costs more than the threads save. The result is at least 1.
int usefulThreads(int wanted, int unknowns);

}  // namespace wend
