#include "core/mesh/skin_file.h"

#include <algorithm>
#include <filesystem>

#include "core/mesh/error.h"
#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/obj_skin.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/gltf.h"
#include "core/mesh/input_file.h"
#include "core/mesh/safe_file.h"
#include "core/mesh/temporary_folder.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

bool hasExtension(const std::string& path, std::string_view extension) {
    return formats::sameWord(fs::path(path).extension().string(), extension);
}

/// Fields of the cells are those of the tetrahedra if there are any: then the triangles have none.
void takeLabels(const MeshFile& file, Skin& skin) {
    if (isVolume(file)) return;
    const MeshField* field = formats::cellField(file, {"label", "ref", "physical", "entity", "attribute"});
    if (!field || std::ranges::all_of(field->values, [](double value) { return value == 0; })) return;
    for (std::size_t t = 0; t < file.triangles.size(); ++t)
        skin.labels.push_back(static_cast<int>(formats::tagOf(field, static_cast<int>(t), 0)));
}

/// Returns the skin as a mesh file with one texture coordinate and the given fields per vertex. Shapes:
/// points 3 × n, uv 2 × n; units are those of the skin. Corners at a texture seam are duplicated.
MeshFile toMeshFile(const Skin& skin, const Points<3>& points, const std::vector<MeshField>& fields) {
    MeshFile file;
    file.points = points;
    file.triangles = skin.triangles;
    if (!skin.uvCorners.empty()) {
        file.uv = Eigen::Matrix2Xd::Zero(2, points.cols());
        for (std::size_t t = skin.triangles.size(); t-- > 0;)  // backwards: the first one stays
            for (int k = 3; k-- > 0;) file.uv.col(skin.triangles[t][k]) = skin.uv.col(skin.uvCorners[t][k]);
    }
    file.fields = fields;
    if (!skin.labels.empty())
        file.fields.push_back({"label", true, 1, {skin.labels.begin(), skin.labels.end()}});
    return file;
}

}  // namespace

Skin readSkin(const std::string& path) {
    const MeshFile file = readMeshFile(path);
    Skin skin;
    skin.path = path;
    skin.points = file.points;
    skin.triangles = file.triangles;
    if (hasExtension(path, ".obj")) {
        formats::addObjLook(readInput(path), skin);
        return skin;
    }
    if (file.uv.cols() > 0) {
        skin.uv = file.uv;
        skin.uvCorners = file.triangles;
    }
    takeLabels(file, skin);
    return skin;
}

std::vector<std::string> lookFilesOf(const std::string& path) {
    if (!hasExtension(path, ".obj")) return {};
    try {
        return formats::objLookFiles(readInput(path), path);
    } catch (const InputError&) {  // reported when the surface is needed
        return {};
    }
}

void writeSkin(const std::string& path, const Skin& skin, const Points<3>& points,
               const std::vector<MeshField>& fields, const MeshWriteOptions& options) {
    if (hasExtension(path, ".glb")) return writeGltf(path, gltfScene(skin, points));
    if (!hasExtension(path, ".obj") || !hasExtension(skin.path, ".obj"))
        return writeMeshFile(path, toMeshFile(skin, points, fields), options);
    fs::path folder = fs::path(path).parent_path();
    if (isTemporary(path)) folder = folder.parent_path();  // where the file will be
    writeWhole(path, formats::withVertices(readInput(skin.path), points,
                                           fs::path(skin.path).parent_path().string(), folder.string()));
}

std::vector<std::string> skinFileExtensions() {
    std::vector<std::string> extensions{".glb"};
    for (const auto& format : formats::meshFormats())
        if (!format.holdsTetrahedra)
            extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
    return extensions;
}

}  // namespace wend
