#pragma once

#include "app/document/project.h"
#include "core/integration/deformer.h"

namespace wend {

/// Solves for v̂ (method.md, Field and energy) at poses of a project's motion, as `wend run` does, beside the
/// motion itself.
template <int Dim>
class VelocityProbe {
  public:
    /// `frame`: see heldHandles(). Throws InputError for what the deformer refuses.
    VelocityProbe(std::shared_ptr<const SimplicialMesh<Dim>> rest,
                  std::shared_ptr<const Material<Dim>> material, const Project& project, const Vec<2>& frame);

    /// One column per vertex, or none if it cannot be solved for.
    Points<Dim> at(double time, const Points<Dim>& pose);

  private:
    Deformer<Dim> m_deformer;
};

}  // namespace wend
