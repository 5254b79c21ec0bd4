#include "core/mesh/mesh_file.h"

#include <filesystem>
#include <fstream>

#include "core/mesh/checked_file.h"
#include "core/mesh/error.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/input_file.h"
#include "core/mesh/safe_file.h"

namespace wend {
namespace fs = std::filesystem;
using formats::MeshFormat;
using formats::MeshSource;

namespace {

std::string bytesOf(const std::string& path) {
    std::string bytes = readInput(path);
    if (bytes.empty()) throw InputError(path, "is empty");
    return bytes;
}

/// The files of one mesh: this one, or its pair.
std::vector<std::string> pathsOf(const MeshFormat& format, const std::string& path) {
    if (!format.together) return {path};
    std::vector<std::string> paths;
    for (const auto extension : format.extensions) {
        const bool given = formats::sameWord(fs::path(path).extension().string(), extension);
        paths.push_back(given ? path : fs::path(path).replace_extension(extension).string());
    }
    return paths;
}

/// Replaces all of the files, or none.
void putAll(const std::vector<std::string>& paths, const std::vector<std::string>& texts) {
    std::vector<PendingFile> files;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        PendingFile file(paths[k], Access::Usual, k > 0 ? &files[0] : nullptr);
        file.fill([&](const std::string& temporary) {
            if (const std::string problem = writeBytes(temporary, texts[k]); !problem.empty())
                throw InputError(paths[k], "cannot be written: " + problem);
        });
        files.push_back(std::move(file));
    }
    PendingFile::commit(files);
}

}  // namespace

MeshFile readMeshFile(const std::string& path) {
    const auto& format = formats::formatOf(path);
    std::vector<MeshSource> sources;
    for (const auto& part : pathsOf(format, path)) sources.push_back({part, bytesOf(part)});
    return formats::readSources(format, sources);
}

void writeMeshFile(const std::string& path, const MeshFile& mesh, const MeshWriteOptions& options) {
    const auto& format = formats::formatOf(path);
    try {
        putAll(pathsOf(format, path), formats::printed(format, mesh, options));
    } catch (const InputError& error) {
        if (!error.file().empty()) throw;
        throw error.named(path);
    }
}

std::vector<MeshFormatFacts> meshFormatFacts() {
    const auto& formats = formats::meshFormats();
    return {formats.begin(), formats.end()};
}

std::vector<std::string> meshFileExtensions() {
    std::vector<std::string> extensions;
    for (const auto& format : formats::meshFormats())
        extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
    return extensions;
}

std::string meshExtensionList(bool tetrahedra) {
    std::string list;
    for (const auto& format : formats::meshFormats())
        if (format.holdsTetrahedra == tetrahedra)
            list += (list.empty() ? "" : ", ") + std::string(format.extensions.front().substr(1));
    return list;
}

const Eigen::Matrix3Xd& pointsOf(const MeshFile& file) {
    return file.points;
}

const std::vector<std::array<int, 3>>& trianglesOf(const MeshFile& file) {
    return file.triangles;
}

const std::vector<std::array<int, 4>>& tetrahedraOf(const MeshFile& file) {
    return file.tetrahedra;
}

const std::vector<int>& labelsOf(const MeshFile& file) {
    return file.labels;
}

const Eigen::Matrix2Xd& uvOf(const MeshFile& file) {
    return file.uv;
}

const std::vector<MeshField>& fieldsOf(const MeshFile& file) {
    return file.fields;
}

bool isVolume(const MeshFile& file) {
    return !file.tetrahedra.empty();
}

template <>
SimplicialMesh<2> meshFrom<2>(const MeshFile& file) {
    if (isVolume(file)) throw InputError("holds tetrahedra where a flat triangle mesh is needed");
    const auto z = file.points.row(2);
    // constant up to rounding: the file may come from a program that rotated the plane
    const double slack = 1e-12 * boundingBoxDiagonal<3>(file.points);
    for (Eigen::Index v = 0; v < z.size(); ++v)
        if (std::abs(z[v] - z[0]) > slack)
            throw InputError("the triangles do not lie in a plane z = constant: vertex " + std::to_string(v) +
                             " is at another height than vertex 0");
    SimplicialMesh<2> mesh{file.points.topRows<2>(), file.triangles};
    requireValid(mesh);
    return mesh;
}

template <>
SimplicialMesh<3> meshFrom<3>(const MeshFile& file) {
    if (!isVolume(file)) throw InputError("holds only triangles where a mesh of tetrahedra is needed");
    SimplicialMesh<3> mesh{file.points, file.tetrahedra};
    requireValid(mesh);
    return mesh;
}

template <>
MeshFile toMeshFile<2>(const SimplicialMesh<2>& mesh) {
    MeshFile file;
    file.points = Eigen::Matrix3Xd::Zero(3, mesh.vertexCount());
    file.points.topRows<2>() = mesh.points;
    file.triangles = mesh.cells;
    return file;
}

template <>
MeshFile toMeshFile<3>(const SimplicialMesh<3>& mesh) {
    MeshFile file;
    file.points = mesh.points;
    file.tetrahedra = mesh.cells;
    return file;
}

std::shared_ptr<const MeshFile> sharedMeshFile(const std::string& path) {
    return std::make_shared<const MeshFile>(readMeshFile(path));
}

std::shared_ptr<const MeshFile> madeMeshFile(const SimplicialMesh<3>& mesh,
                                             const std::vector<std::array<int, 3>>& boundary,
                                             const std::vector<int>& labels,
                                             const std::vector<std::string>& labelNames) {
    auto file = std::make_shared<MeshFile>(toMeshFile<3>(mesh));
    file->made = true;
    file->triangles = boundary;
    file->labels = labels;
    file->labelNames = labelNames;
    return file;
}

template <int Dim>
SimplicialMesh<Dim> readMesh(const std::string& path) {
    return meshFrom<Dim>(readMeshFile(path));
}

template <int Dim>
void writeMesh(const std::string& path, const SimplicialMesh<Dim>& mesh) {
    writeMeshFile(path, toMeshFile<Dim>(mesh));
}

int dimensionOfMesh(const std::string& path) {
    return isVolume(readMeshFile(path)) ? 3 : 2;
}

template SimplicialMesh<2> readMesh<2>(const std::string&);
template SimplicialMesh<3> readMesh<3>(const std::string&);
template void writeMesh<2>(const std::string&, const SimplicialMesh<2>&);
template void writeMesh<3>(const std::string&, const SimplicialMesh<3>&);

}  // namespace wend
