#include "tests/support/mesh_files.h"

#include "core/mesh/mesh_file.h"

namespace wend::test {

void writeSurface(const std::string& path, const Surface& surface, const Eigen::Matrix2Xd& uv) {
    MeshFile file;
    file.points = surface.points;
    file.triangles = surface.triangles;
    file.uv = uv;
    writeMeshFile(path, file);
}

void writeSolid(const std::string& path, const SimplicialMesh<3>& mesh,
                const std::vector<MeshField>& fields) {
    MeshFile file = toMeshFile<3>(mesh);
    file.fields = fields;
    writeMeshFile(path, file);
}

const std::vector<std::string>& labelNamesOf(const MeshFile& file) {
    return file.labelNames;
}

Surface surfaceOf(const SimplicialMesh<2>& mesh) {
    const MeshFile file = toMeshFile<2>(mesh);
    return {file.points, file.triangles, {}};
}

}  // namespace wend::test
