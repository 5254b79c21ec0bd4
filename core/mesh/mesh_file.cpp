#include "core/mesh/mesh_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/base/checked_file.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/number_text.h"
#include "core/base/safe_file.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/scanner.h"
#include "core/mesh/plane_frame.h"

namespace wend {
namespace fs = std::filesystem;
using formats::MeshFormat;
using formats::MeshSource;

namespace {

std::string bytesOf(const std::string& path) {
    std::string bytes = readInput(path);
    if (bytes.empty()) throw InputError(path, sentence("Core", "is empty"));
    return bytes;
}

/// Returns the files of one mesh: this one, or its pair.
std::vector<std::string> pathsOf(const MeshFormat& format, const std::string& path) {
    if (format.together == 1) return {path};
    std::vector<std::string> paths;
    for (const auto extension : format.extensions) {
        const bool given = formats::sameWord(fs::path(path).extension().string(), extension);
        paths.push_back(given ? path : fs::path(path).replace_extension(extension).string());
    }
    return paths;
}

/// Returns the files that may accompany a pair: TetGen's faces and edges.
std::vector<std::string> besides(const MeshFormat& format, const std::string& path) {
    if (format.together == 1) return {};
    std::vector<std::string> paths;
    for (const char* extension : {".face", ".edge"})
        paths.push_back(fs::path(path).replace_extension(extension).string());
    return paths;
}

/// Replaces all of the files, or none.
void putAll(const std::vector<std::string>& paths, const std::vector<std::string>& texts) {
    std::vector<PendingFile> files;
    for (std::size_t k = 0; k < texts.size(); ++k) {
        if (texts[k].empty()) continue;  // an optional companion of a pair
        PendingFile file(paths[k], Access::Usual, files.empty() ? nullptr : &files[0]);
        file.fill([&](const std::string& temporary) {
            if (const std::string problem = writeBytes(temporary, texts[k]); !problem.empty())
                throw InputError(paths[k], {sentence("Core", "cannot be written: %1"), problem});
        });
        files.push_back(std::move(file));
    }
    PendingFile::commit(files);
}

}  // namespace

MeshFile readMeshFile(const std::string& path, MeshNeeds needs) {
    for (const auto& format : formats::inputFormats())
        if (formats::sameWord(fs::path(path).extension().string(), format.extension))
            return formats::readSource(format, {path, bytesOf(path)}, needs);
    const auto& format = formats::formatOf(path);
    std::vector<MeshSource> sources;
    for (const auto& part : pathsOf(format, path))
        sources.push_back({part, format.writesPointsAlone ? readInput(part) : bytesOf(part)});
    for (const auto& part : besides(format, path))
        sources.push_back({part, fs::exists(part) ? readInput(part) : std::string()});
    return formats::readSources(format, sources, needs);
}

void writeMeshFile(const std::string& path, const MeshFile& mesh, const MeshWriteOptions& options) {
    const auto& format = formats::formatOf(path);
    try {
        std::vector<std::string> paths = pathsOf(format, path);
        for (const auto& part : besides(format, path)) paths.push_back(part);
        putAll(paths, formats::printed(format, mesh, options));
    } catch (const InputError& error) {
        if (!error.file().empty()) throw;
        throw error.named(path);
    }
}

std::string lostInFile(const std::string& path, const MeshFile& mesh, const MeshWriteOptions& options) {
    return formats::lostIn(formats::formatOf(path), mesh, options);
}

bool holdsPointsAlone(const std::string& path) {
    return formats::formatOf(path).holdsPointsAlone();
}

std::string roundingText(const Eigen::Matrix3Xd& points) {
    constexpr double kNoticed = 1e-6;
    if (points.cols() == 0) return {};
    const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm(),
                 off = (points - points.cast<float>().cast<double>()).colwise().norm().maxCoeff();
    if (!(off > kNoticed * size)) return {};
    return "single precision moves vertices by up to " + numberText(off) +
           ", because they are far from the origin; --encoding text keeps all digits";
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

std::vector<std::string> readableMeshExtensions() {
    std::vector<std::string> extensions = meshFileExtensions();
    for (const auto& format : formats::inputFormats()) extensions.emplace_back(format.extension);
    return extensions;
}

std::string meshExtensionList(bool tetrahedra) {
    std::string list;
    for (const auto& format : formats::meshFormats())
        if (format.holdsTetrahedra == tetrahedra && !format.writesPointsAlone)
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

namespace {

/// Makes all cells positive, which are numbered in both orientations.
template <int Dim>
void turnInside(SimplicialMesh<Dim>& mesh) {
    std::vector<int> negative;
    for (int c = 0; c < mesh.cellCount(); ++c)
        if (cellMeasure<Dim>(mesh.points, mesh.cells[c]) < 0) negative.push_back(c);
    if (static_cast<int>(negative.size()) == mesh.cellCount()) return;
    for (const int c : negative) std::swap(mesh.cells[c][Dim - 1], mesh.cells[c][Dim]);
}

/// Returns whether the facet's vertices and the one opposite are an odd permutation of the cell's.
template <int Dim>
bool isOdd(const Cell<Dim>& cell, const std::array<int, Dim>& facet) {
    std::array<int, Dim + 1> order;  // places in the cell
    int sum = 0;
    for (int k = 0; k < Dim; ++k)
        sum += order[k] = static_cast<int>(std::ranges::find(cell, facet[k]) - cell.begin());
    order[Dim] = Dim * (Dim + 1) / 2 - sum;
    int inversions = 0;
    for (int i = 0; i <= Dim; ++i)
        for (int j = 0; j < i; ++j) inversions += order[j] > order[i];
    return inversions % 2 != 0;
}

}  // namespace

template <int Dim>
std::vector<std::array<int, 2>> foldedPairs(const SimplicialMesh<Dim>& mesh) {
    std::vector<std::array<int, 2>> pairs;
    for (const auto& facet : facetsOf<Dim>(mesh))
        if (facet.interior() && isOdd<Dim>(mesh.cells[facet.cells[0]], facet.vertices) ==
                                    isOdd<Dim>(mesh.cells[facet.cells[1]], facet.vertices))
            pairs.push_back(facet.cells);
    return pairs;
}
template std::vector<std::array<int, 2>> foldedPairs<2>(const SimplicialMesh<2>&);
template std::vector<std::array<int, 2>> foldedPairs<3>(const SimplicialMesh<3>&);

namespace {

/// Makes the partition of the cells as a file numbers them valid: neighbours are on both sides of the facet
/// between them.
template <int Dim>
void makeValid(const MeshFile& file, SimplicialMesh<Dim>& mesh) {
    if (std::ranges::none_of(mesh.cells, [&](const auto& cell) {
            return std::ranges::any_of(cell, [&](int v) { return v < 0 || v >= mesh.vertexCount(); });
        }))
        turnInside<Dim>(mesh);
    requireValid(mesh);
    const auto folded = foldedPairs<Dim>(mesh);
    if (folded.empty()) return;
    const auto& cellOf = Dim == 3 ? file.cellOfTetrahedron : file.cellOfTriangle;
    const auto number = [&](int c) { return std::to_string(cellOf.empty() ? c : cellOf[c]); };
    throw InputError("cells " + number(folded[0][0]) + " and " + number(folded[0][1]) +
                     " overlap: they lie on the same side of the " + (Dim == 2 ? "edge" : "face") +
                     " between them");
}

}  // namespace

template <>
SimplicialMesh<2> meshFrom<2>(const MeshFile& file) {
    if (isVolume(file)) throw InputError("holds tetrahedra where a flat triangle mesh is needed");
    const auto plane = planeOf(file.points, file.triangles);
    if (!plane) throw InputError("the triangles do not lie in a plane");
    SimplicialMesh<2> mesh{plane->toPlane(file.points).topRows<2>(), file.triangles};
    makeValid<2>(file, mesh);
    return mesh;
}

template <>
SimplicialMesh<3> meshFrom<3>(const MeshFile& file) {
    if (!isVolume(file)) throw InputError("holds only triangles where a mesh of tetrahedra is needed");
    SimplicialMesh<3> mesh{file.points, file.tetrahedra};
    makeValid<3>(file, mesh);
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
                                             const NamedLabels& labels, const NamedLabels& spaces) {
    auto file = std::make_shared<MeshFile>(toMeshFile<3>(mesh));
    file->made = true;
    file->triangles = boundary;
    file->labels = labels.labels;
    file->labelNames = labels.names;
    if (spaces.labels.empty()) return file;
    MeshField ref{"ref", true, 1, {spaces.labels.begin(), spaces.labels.end()}};
    ref.type = formats::Scalar::Int32;
    file->fields.push_back(std::move(ref));
    file->spaceNames = spaces.names;
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
