#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/outline.h"

namespace wend {

/// The targets and limits of a refinement.
struct RefinementBounds {
    double circumradius = 0;  // of every triangle at most, times the factor there
    double minAngle = 25;     // degrees
    double shortest =
        0;  // edges at or below this length are not split for the angle's or the boundary's sake
    int maxVertices = 0;  // beyond that there is no result
};

/// The constrained Delaunay triangulation of an outline and points, from which refined meshes are made. It
/// hides CGAL.
class PlanarDomain {
  public:
    using Factor = std::function<double(const Vec2&)>;
    /// The outline must be clean and without crossings. `factor`: see PlanarMeshOptions. Throws InputError
    /// for points that are outside or coincide.
    PlanarDomain(const Outline& outline, const std::vector<Vec2>& points, Factor factor = {});
    ~PlanarDomain();

    /// Return how many edges of the local target length fit in: ∫ f⁻² dA and ∫ f⁻¹ ds.
    double area() const;
    double perimeter() const;
    int vertexCount() const;

    /// Returns the mesh, or nothing if it would need more than maxVertices. Throws Cancelled.
    std::optional<SimplicialMesh<2>> refined(const RefinementBounds& bounds,
                                             const std::stop_token& stop) const;
    /// Returns the triangulation itself, without added vertices.
    SimplicialMesh<2> unrefined() const;

  private:
    struct Triangulation;
    std::unique_ptr<const Triangulation> m_triangulation;
    Factor m_factor;
    int m_pointCount;
};

}  // namespace wend
