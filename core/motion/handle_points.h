#pragma once

#include "core/mesh/point_locator.h"
#include "core/motion/constraints.h"

namespace wend {

/// The constrained points of handles, in the handles' order; a point that a handle names twice counts once.
template <int Dim>
class HandlePlacer {
  public:
    HandlePlacer(const SimplicialMesh<Dim>& rest, const Normalization<Dim>& units);

    /// Throws InputError without the handle's name: see Constraints.
    std::vector<ConstrainedPoint> place(const Placement<Dim>& at, int handle) const;

  private:
    using Terms = std::vector<std::pair<int, double>>;
    std::vector<Terms> termsOf(const std::vector<int>& vertices) const;
    std::vector<Terms> termsOf(const std::vector<Vec<Dim>>& points) const;
    std::vector<Terms> termsOf(const Region<Dim>& region) const;
    Terms termsOf(const Vec<Dim>& p) const;

    const SimplicialMesh<Dim>& m_rest;
    const Normalization<Dim>& m_units;
    double m_size;
    std::vector<int> m_standsFor;  // per vertex its twin that belongs to a cell; −1 for none
    PointLocator<Dim> m_locator;
};

}  // namespace wend
