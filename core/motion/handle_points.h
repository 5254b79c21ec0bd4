#pragma once

#include <memory>
#include <span>

#include "core/mesh/point_locator.h"
#include "core/motion/constraints.h"

namespace wend {

/// Finds the constrained points of handles, in the handles' order; a point that a handle names twice counts
/// once.
template <int Dim>
class HandlePlacer {
  public:
    HandlePlacer(const SimplicialMesh<Dim>& rest, const Normalization<Dim>& units);

    /// Returns the points of the handle with that number, in the part that it names, otherwise each in the
    /// frontmost part that has its place; a region takes the vertices of one part. Vertices are those of the
    /// part, if one is named. Throws InputError without the handle's name: see Constraints.
    std::vector<ConstrainedPoint> place(const Handle<Dim>& handle, int number) const;

  private:
    using Terms = std::vector<std::pair<int, double>>;
    struct Part {
        Part(const SimplicialMesh<Dim>& rest, const MeshPart& range);
        MeshPart range;
        std::vector<Cell<Dim>> cells;
        PointLocator<Dim> locator;  // refers to the cells
    };
    using Parts = std::span<const std::unique_ptr<const Part>>;
    Parts partsFor(const std::string& name) const;
    std::vector<Terms> termsOf(const std::vector<int>& vertices, const Parts& parts) const;
    std::vector<Terms> termsOf(const std::vector<Vec<Dim>>& points, const Parts& parts) const;
    std::vector<Terms> termsOf(const Region<Dim>& region, const Parts& parts) const;
    Terms termsIn(const Part& part, const Vec<Dim>& p) const;

    const SimplicialMesh<Dim>& m_rest;
    const Normalization<Dim>& m_units;
    double m_size;
    std::vector<int> m_standsFor;  // per vertex its twin that belongs to a cell; −1 for none
    std::vector<std::unique_ptr<const Part>> m_parts;  // from front to back
};

}  // namespace wend
