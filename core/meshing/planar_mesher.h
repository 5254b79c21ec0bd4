#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/outline.h"

namespace wend {

/// The options of meshOutline().
struct PlanarMeshOptions {
    int vertices = 5000;   // aim, met within 10 % (see meshOutline); ignored when edge > 0
    double edge = 0;       // aim for the mean edge length
    double minAngle = 25;  // degrees, 0 … 30, away from corners of the input that are sharper
    /// The most by which the outline may be simplified. It is simplified only if it has more detail than the
    /// aimed number of vertices allows. With 0 the mesh's boundary is the outline exactly.
    double simplify = 0;
    /// Returns the length of edges at a place, relative to elsewhere; positive. If empty, edges are even.
    std::function<double(const Vec2&)> factor;
    std::vector<Vec2> points;  // become vertices of the mesh: where handles sit
    std::stop_token stop;
};

/// Meshes the inside by conforming constrained Delaunay refinement (CGAL Delaunay_mesher_2): uniform
/// triangles (bounded circumradius, times the factor if there is one), finer only where the outline or the
/// points require it. Vertex i is options.points[i], bit for bit, for every point; all cells have positive
/// measure det[x1 − x0, x2 − x0] / 2; boundaries are subdivided outline segments. A point within 1e-9
/// (relative to the bounding box's diagonal) of the outline becomes part of it.
/// A target below what the outline needs at the minimum angle gives that smallest mesh (after simplification
/// within options.simplify) instead of an error. Where boundaries or points nearly touch, edges are not split
/// for the angle's sake below 1e-5 of the target spacing, or below more if the mesh would become many times
/// larger than the target, so that meshing always ends.
/// The outline may touch itself at points; crossing or overlapping edges are refused. Polygons nest by the
/// even-odd rule. Throws InputError: outline empty, not finite, without area or crossing itself (with the
/// place); a point outside or coincident with another (with index and coordinates); options out of range.
/// Throws Cancelled when stopped.
SimplicialMesh<2> meshOutline(const Outline& outline, const PlanarMeshOptions& options);

}  // namespace wend
