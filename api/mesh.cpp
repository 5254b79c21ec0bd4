#include "wend/mesh.h"

#include "api/boundary.h"
#include "core/mesh/mesh_of_file.h"
#include "core/meshing/planar_mesher.h"
#include "core/meshing/volume_mesher.h"

namespace wend {

int meshDimension(const std::string& path) {
    return documented([&] { return dimensionOfMesh(path); });
}

template <int Dim>
Mesh<Dim> loadMesh(const std::string& path) {
    return documented([&] { return meshOf<Dim>(readMesh<Dim>(path)); });
}

template <int Dim>
void saveMesh(const std::string& path, const Mesh<Dim>& mesh) {
    documented([&] { writeMesh<Dim>(path, meshOf<Dim>(mesh.points, mesh.cells)); });
}

Mesh<2> meshPolygons(const std::vector<std::vector<Coordinates<2>>>& polygons, const PolygonMeshing& given) {
    Outline outline;
    for (const auto& polygon : polygons) outline.loops.push_back(vecsOf<2>(polygon));
    PlanarMeshOptions options;
    options.vertices = given.vertices;
    options.edge = given.edge;
    options.minAngle = given.minAngle;
    options.points = vecsOf<2>(given.points);
    options.stop = given.stop;
    return documented([&] { return meshOf<2>(meshOutline(outline, options)); });
}

Mesh<3> fillSurface(std::span<const Coordinates<3>> points, std::span<const std::array<int, 3>> triangles,
                    const SurfaceFilling& given) {
    VolumeMeshOptions options;
    options.vertices = given.vertices;
    options.maxVolume = given.maxVolume;
    options.quality = given.quality;
    options.keepSurface = given.keepSurface;
    options.stop = given.stop;
    const Surface surface{columnsOf<3>(points), {triangles.begin(), triangles.end()}, {}};
    return documented([&] { return meshOf<3>(meshVolume(surface, options).mesh); });
}

#define WEND_INSTANTIATE(Dim)                                      \
    template WEND_API Mesh<Dim> loadMesh<Dim>(const std::string&); \
    template WEND_API void saveMesh<Dim>(const std::string&, const Mesh<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
