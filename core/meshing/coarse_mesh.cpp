#include "core/meshing/coarse_mesh.h"

#include <cmath>

#include "core/mesh/boundary_loops.h"
#include "core/mesh/error.h"
#include "core/mesh/skin.h"
#include "core/meshing/cage.h"
#include "core/meshing/planar_mesher.h"

namespace wend {

namespace {

constexpr double kSameArea = 0.02;  // what simplification may change of it

double areaOf(const SimplicialMesh<2>& mesh) {
    double area = 0;
    for (const Cell<2>& cell : mesh.cells) area += std::abs(cellMeasure<2>(mesh.points, cell));
    return area;
}

}  // namespace

template <>
SimplicialMesh<2> coarseMesh<2>(const SimplicialMesh<2>& fine, int vertices, std::stop_token stop) {
    const double area = areaOf(fine);
    PlanarMeshOptions options;
    options.vertices = vertices;
    options.simplify = std::sqrt(area / vertices);
    options.stop = stop;
    SimplicialMesh<2> coarse = meshOutline({boundaryLoops(fine)}, options);
    if (std::abs(areaOf(coarse) - area) > kSameArea * area)
        throw InputError("the shape covers itself at rest: its outline does not tell where it is");
    return coarse;
}

template <>
SimplicialMesh<3> coarseMesh<3>(const SimplicialMesh<3>& fine, int vertices, std::stop_token stop) {
    const Skin boundary = boundaryOf(fine);
    CageOptions options;
    options.vertices = vertices;
    options.stop = stop;
    return fitCage({boundary.points, boundary.triangles, {}}, options).mesh;
}

}  // namespace wend
