#include "core/mesh/skin_file.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/safe_file.h"
#include "core/base/temporary_folder.h"
#include "core/mesh/formats/colours.h"
#include "core/mesh/formats/gltf_read.h"
#include "core/mesh/formats/mesh_bag.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/obj_skin.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/gltf.h"
#include "core/mesh/turned_normals.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

bool hasExtension(const std::string& path, std::string_view extension) {
    return formats::sameWord(fs::path(path).extension().string(), extension);
}

/// Returns what can be written of a skin without a file: one texture point per vertex, and labels.
MeshFile madeFile(const Skin& skin) {
    MeshFile file;
    file.triangles = skin.triangles;
    if (!skin.labels.empty())
        file.fields.push_back({"label", true, 1, {skin.labels.begin(), skin.labels.end()}});
    if (skin.uvCorners.empty()) return file;
    file.uv = Eigen::Matrix2Xd::Zero(2, skin.points.cols());
    for (std::size_t t = skin.triangles.size(); t-- > 0;)  // backwards: the first one stays
        for (int k = 3; k-- > 0;) file.uv.col(skin.triangles[t][k]) = skin.uv.col(skin.uvCorners[t][k]);
    return file;
}

/// Returns the file that the skin comes from, with polygons, lines, groups and fields, or what can be written
/// without one.
MeshFile toMeshFile(const Skin& skin, const Points3& points, const std::vector<MeshField>& fields) {
    MeshFile file = skin.path.empty() ? madeFile(skin) : readMeshFile(skin.path, MeshNeeds::Points);
    const Points3 before = skin.path.empty() ? points : Points3(file.points);
    if (before.cols() != points.cols())
        throw InputError(skin.path, "has changed: it has " + std::to_string(before.cols()) +
                                        " vertices, where " + std::to_string(points.cols()) + " were read");
    file.points = points;
    turnNormals(before, file);
    for (const MeshField& field : fields) {
        std::erase_if(file.fields, [&](const auto& old) {
            return old.name == field.name && old.perCell == field.perCell;
        });
        file.fields.push_back(field);
    }
    if (!skin.labels.empty())  // for formats without groups
        file.fields.push_back({"label", true, 1, {skin.labels.begin(), skin.labels.end()}});
    return file;
}

/// Adds the texture points of the corners of a file's faces to its triangles, equal ones once.
void addCornerTexture(const MeshFile& file, Skin& skin) {
    std::map<std::pair<double, double>, int> known;
    for (std::size_t t = 0; t < file.triangles.size(); ++t) {
        const int cell = file.cellOfTriangle[t];
        const auto nodes = file.cells[cell];
        std::array<int, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = file.cells.begins[static_cast<std::size_t>(cell)] +
                            (std::ranges::find(nodes, file.triangles[t][k]) - nodes.begin());
            const auto first = file.cornerUv.begin() + 2 * at;
            corners[k] =
                known.try_emplace({first[0], first[1]}, static_cast<int>(known.size())).first->second;
        }
        skin.uvCorners.push_back(corners);
    }
    skin.uv.resize(2, static_cast<Eigen::Index>(known.size()));
    for (const auto& [uv, number] : known) skin.uv.col(number) << uv.first, uv.second;
}

constexpr std::size_t kMostColours = 256;  // of faces

/// Adds a material for every colour that the faces of a file have, unless there are too many.
void addFaceColours(const MeshFile& file, Skin& skin) {
    const std::vector<formats::Colour> colours = formats::coloursOf(file, true);
    if (!skin.materials.empty() || colours.size() != static_cast<std::size_t>(file.cells.size())) return;
    std::map<formats::Colour, int> known;
    std::vector<int> materialOf;
    for (const int c : file.cellOfTriangle) {
        const formats::Colour& colour = colours[static_cast<std::size_t>(c)];
        const auto [found, isNew] = known.try_emplace(colour, static_cast<int>(known.size()));
        if (known.size() > kMostColours) return;
        materialOf.push_back(found->second);
    }
    skin.materials.resize(known.size());
    for (const auto& [colour, number] : known) {
        SkinMaterial& material = skin.materials[static_cast<std::size_t>(number)];
        material.name = "colour " + std::to_string(number + 1);
        std::ranges::transform(colour, material.colour.begin(),
                               [](double part) { return static_cast<float>(part); });
    }
    skin.materialOf = std::move(materialOf);
}

/// Returns what a .glb file does not hold of a file that is drawn by it.
std::string lostInGltf(const MeshFile& file, const MeshWriteOptions& options) {
    MeshFile drawn = file;
    std::erase_if(drawn.fields, [&](const MeshField& field) {
        return formats::isColour(field, false) || isNormals(field) ||
               (formats::isColour(field, true) && formats::coloursOf(file, true).size() <= kMostColours);
    });
    std::erase_if(drawn.groups, [](const MeshGroup& group) { return group.material; });
    return formats::lostInGltf(drawn, options);
}

}  // namespace

Skin readSkin(const std::string& path, MeshNeeds needs) {
    const MeshFile file = readMeshFile(path, needs);
    Skin skin;
    skin.path = path;
    skin.points = file.points;
    skin.triangles = file.triangles;
    skin.colours = formats::coloursOf(file, false);
    if (hasExtension(path, ".obj")) {
        formats::addObjLook(readInput(path), file, skin);
        return skin;
    }
    if (hasExtension(path, ".glb")) {
        formats::addGltfLook(readInput(path), skin);
    } else if (file.uv.cols() > 0 && file.hasCornerUv()) {
        addCornerTexture(file, skin);
    } else if (file.uv.cols() > 0) {
        skin.uv = file.uv;
        skin.uvCorners = file.triangles;
    }
    if (isVolume(file)) return skin;
    addFaceColours(file, skin);
    formats::SurfaceLabels labels = formats::surfaceLabels(file);
    skin.labels = std::move(labels.labels);
    skin.labelNames = std::move(labels.names);
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

void writeSkin(const std::string& path, const Skin& skin, const Points3& points,
               const std::vector<MeshField>& fields, const MeshWriteOptions& options) {
    requireSkinHeldBy(path, skin);
    if (hasExtension(path, ".glb")) return writeGltf(path, gltfScene(skin, points));
    if (!hasExtension(path, ".obj") || !hasExtension(skin.path, ".obj"))
        return writeMeshFile(path, toMeshFile(skin, points, fields), options);
    fs::path folder = fs::path(path).parent_path();
    if (isTemporary(path)) folder = folder.parent_path();  // where the file will be
    writeWhole(path, formats::withVertices(readInput(skin.path), skin, points, folder.string()));
}

void requireSkinHeldBy(const std::string& path, const Skin& skin) {
    if (!skin.triangles.empty()) return;
    if (hasExtension(path, ".glb") || !holdsPointsAlone(path))
        throw InputError(path, "the format cannot hold points and lines without triangles");
}

/// An OBJ file stays what it is.
std::string lostInSkin(const std::string& path, const Skin& skin, const MeshWriteOptions& options) {
    const bool kept = hasExtension(path, ".obj") && hasExtension(skin.path, ".obj");
    if (skin.path.empty() || kept) return {};
    const MeshFile file = readMeshFile(skin.path, MeshNeeds::Points);
    return hasExtension(path, ".glb") ? lostInGltf(file, options) : lostInFile(path, file, options);
}

std::vector<std::string> skinFileExtensions() {
    std::vector<std::string> extensions{".glb"};
    for (const auto& format : formats::meshFormats())
        if (!format.holdsTetrahedra)
            extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
    return extensions;
}

}  // namespace wend
