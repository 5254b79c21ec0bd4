#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/outline.h"

namespace wend {

struct PlanarMeshOptions {
    int vertices = 5000;         // aim, met within 10 %; ignored when edge > 0
    double edge = 0;             // aim for the edge length
    double minAngle = 25;        // degrees, away from corners of the input that are sharper
    std::vector<Vec<2>> points;  // become vertices of the mesh: where handles sit
    std::stop_token stop;
};

/// Conforming constrained Delaunay refinement (CGAL Delaunay_mesher_2) of the inside. Vertices
/// options.points[i] is vertex i of the result, bit for bit. All cells have positive measure det[x1 − x0, x2
/// − x0] / 2. Throws InputError: outline empty, degenerate, not finite or crossing itself (with the place); a
/// point outside; two points that coincide; an aim that cannot be met.
SimplicialMesh<2> meshOutline(const Outline& outline, const PlanarMeshOptions& options);

}  // namespace wend
