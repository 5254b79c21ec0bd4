#pragma once

#include "core/assembly/back_end.h"

namespace wend {

/// The CPU back end for B = I, several times faster than the general one: structures of arrays, loops
/// vectorized for the processor at hand, blocks in closed form.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeIsotropicBackEnd(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                                   const SimplicialMesh<Dim>& rest,
                                                   const Material<Dim>& material, int threads);

}  // namespace wend
