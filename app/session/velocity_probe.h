#pragma once

#include "app/document/project.h"
#include "app/session/shape.h"
#include "core/integration/deformer.h"

namespace wend {

/// Solves for v̂ (method.md, Field and energy) at poses of a project's motion, as `wend run` does, beside the
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

}  // namespace wend
