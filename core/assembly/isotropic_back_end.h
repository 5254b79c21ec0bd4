#pragma once

#include "core/assembly/back_end.h"

namespace wend {

/// Makes the CPU back end for B = I, which is several times faster than the general one: it uses structures
/// of arrays, loops that are vectorized for the processor in use, and blocks in closed form.
template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeIsotropicBackEnd(std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                                   const SimplicialMesh<Dim>& rest,
                                                   const Material<Dim>& material, int threads);

}  // namespace wend
