#pragma once

#include "app/document/project_fwd.h"
#include "app/session/shape/shape.h"
#include "core/integration/deformer.h"
#include "core/motion/handle.h"

namespace wend {

/// Solves for v̂ (docs/method.md, (13)) at poses of a project's motion, as `wend run` does, beside the
/// motion itself.
template <int Dim>
class VelocityProbe {
  public:
    /// Throws InputError for what the deformer refuses.
    VelocityProbe(const Shape<Dim>& shape, const Project& project);

    /// One column per vertex, or none if it cannot be solved for.
    Points<Dim> at(double time, const Points<Dim>& pose);

  private:
    Deformer<Dim> m_deformer;
};

/// How far some handles take each vertex along, held as the project holds the others at that time: with v̂ₖ
/// the field in which those handles move by one unit along coordinate k and all others rest,
/// (Σₖ |v̂ₖ|² / Dim)^½ in the first row. 1 at the handles, 0 where others hold; without the memory, which has
/// a velocity of its own. No columns if it cannot be solved for.
template <int Dim>
Points<Dim> influenceAt(const Shape<Dim>& shape, const Project& project, const std::vector<int>& handles,
                        double time, const Points<Dim>& pose);

}  // namespace wend
