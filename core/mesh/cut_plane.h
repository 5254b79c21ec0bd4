#pragma once

#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The cutting plane of a solid: the side that the normal points to is removed.
struct CutPlane {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitX();

    /// Returns the height of a point above the plane, which is positive on the removed side.
    double height(const Vec3& p) const { return normal.dot(p - point); }
};

/// Triangles to draw: three corners each (as weights of the mesh's vertices, so that any pose can be drawn
/// with them), the cell behind each, and whether it is part of the cut.
struct CutSurface {
    /// A corner of a triangle, as a point of an edge of the mesh, so that any pose moves it.
    struct Corner {
        int from, to;   // vertices
        double weight;  // of `to`: the corner is (1 − weight) x_from + weight x_to
    };
    std::vector<std::array<Corner, 3>> triangles;
    std::vector<int> cells;
    std::vector<bool> onCut;
};

/// Returns the whole surface of the solid: its boundary facets.
CutSurface wholeSurface(const std::vector<Facet<3>>& facets);

/// Returns the surface of the union of all cells whose centroid is not cut off ("crinkle" cut). Triangles
/// between a cell that stays and one that does not are on the cut.
CutSurface wholeCellCut(const SimplicialMesh<3>& mesh, const std::vector<Facet<3>>& facets,
                        const Points3& pose, const CutPlane& plane);

/// Returns the exact cut: the boundary facets clipped at the plane, and the plane's sections of all cells
/// that it crosses. Sections face along the plane's normal. A vertex on the plane counts as staying, so a
/// plane through vertices may give triangles without area, but no gap. Time is linear in facets and cells.
CutSurface exactCut(const SimplicialMesh<3>& mesh, const std::vector<Facet<3>>& facets, const Points3& pose,
                    const CutPlane& plane);

}  // namespace wend
