#pragma once

#include "app/engine/shape/shape.h"
#include "app/project/project_fwd.h"
#include "core/integration/deformer.h"
#include "core/motion/handle.h"

namespace wend {

/// Solves for v̂ (docs/method.md, (13)) at poses of a project's motion, as `wend run` does, without changing
/// the motion.
template <int Dim>
class VelocityProbe {
  public:
    /// Throws InputError if the deformer rejects the shape or its handles.
    VelocityProbe(const Shape<Dim>& shape, const Project& project);

    /// Returns one column per vertex, or none if the field cannot be solved.
    Points<Dim> at(double time, const Points<Dim>& pose);

  private:
    Deformer<Dim> m_deformer;
};

/// Returns the influence of some handles on each vertex, (Σₖ |v̂ₖ|² / Dim)^½, in the first row: v̂ₖ is the
/// field for unit motion of those handles along coordinate k while all others that act at that time rest. It
/// is 1 at the handles and 0 where others hold. The memory is left out, because it has a velocity of its own.
/// No columns if the field cannot be solved.
template <int Dim>
Points<Dim> influenceAt(const Shape<Dim>& shape, const Project& project, const std::vector<int>& handles,
                        double time, const Points<Dim>& pose);

}  // namespace wend
