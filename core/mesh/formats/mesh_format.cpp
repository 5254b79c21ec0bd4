#include "core/mesh/formats/mesh_format.h"

#include <filesystem>

#include "core/mesh/error.h"
#include "core/mesh/formats/boundary_values.h"
#include "core/mesh/formats/cell_collector.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

template <std::size_t N>
void requireIndices(const std::vector<std::array<int, N>>& cells, Eigen::Index vertexCount,
                    const char* kind) {
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (int v : cells[c])
            if (v < 0 || v >= vertexCount)
                throw InputError(std::string(kind) + " " + std::to_string(c) + " names vertex " +
                                 std::to_string(v) + ", but there are only " + std::to_string(vertexCount) +
                                 " (counted from 0)");
}

void requireFields(const MeshFile& file) {
    for (const auto& field : file.fields) {
        const auto count = field.perCell ? cellCount(file) : file.points.cols();
        if (field.components < 1 ||
            static_cast<Eigen::Index>(field.values.size()) != count * field.components)
            throw InputError("the field " + inQuotes(field.name) + " has " +
                             std::to_string(field.values.size()) + " values where " + std::to_string(count) +
                             " times " + std::to_string(field.components) + " are needed");
    }
    if (file.uv.cols() != 0 && file.uv.cols() != file.points.cols())
        throw InputError("there are " + std::to_string(file.uv.cols()) + " texture coordinates for " +
                         std::to_string(file.points.cols()) + " vertices");
}

/// What every reader must hand over and every printer may rely on.
void requireSound(const MeshFile& file) {
    if (file.points.cols() == 0) throw InputError("there is no vertex in it");
    if (cellCount(file) == 0)
        throw InputError(
            "holds " + std::to_string(file.points.cols()) +
            " points, but neither triangles nor tetrahedra between them: a surface has to be made of "
            "the points first, as MeshLab and CloudCompare do");
    for (Eigen::Index v = 0; v < file.points.cols(); ++v)
        if (!file.points.col(v).allFinite())
            throw InputError("vertex " + std::to_string(v) + " has a coordinate that is not a finite number");
    requireIndices(file.triangles, file.points.cols(), "triangle");
    requireIndices(file.tetrahedra, file.points.cols(), "tetrahedron");
    requireFields(file);
}

void requireCarriable(const MeshFormat& format, const MeshFile& mesh) {
    if (mesh.tetrahedra.empty() || format.holdsTetrahedra) return;
    std::string able;
    for (const auto& other : meshFormats())
        if (other.holdsTetrahedra) able += " " + std::string(other.extensions.front());
    throw InputError("a " + std::string(format.name) + " file cannot hold tetrahedra; these can:" + able);
}

/// What is written of a mesh that was made here, or whose boundary was asked for.
MeshFile asWritten(const MeshFile& mesh, const MeshFormat& format, const MeshWriteOptions& options) {
    MeshFile file = usedPart(mesh);
    if (!isVolume(file)) return file;
    if (file.triangles.empty() && options.boundary) return withBoundary(std::move(file));
    return mesh.made && !format.withBoundary && !options.boundary ? withoutBoundary(std::move(file)) : file;
}

}  // namespace

const std::vector<MeshFormat>& meshFormats() {
    static const std::vector<MeshFormat> formats = {
        // name, extensions, together, tetrahedra, withBoundary, fields, binary; reader, printer
        {{"Wavefront OBJ", {".obj"}, false, false, false, false, false}, readObj, printObj},
        {{"PLY", {".ply"}, false, false, false, true, true}, readPly, printPly},
        {{"OFF", {".off"}, false, false, false, false, false}, readOff, printOff},
        {{"STL", {".stl"}, false, false, false, false, true}, readStl, printStl},
        {{"VTU (ParaView)", {".vtu"}, false, true, false, true, true}, readVtu, printVtu},
        {{"VTK", {".vtk"}, false, true, false, true, true}, readVtk, printVtk},
        {{"Medit", {".mesh"}, false, true, true, false, false}, readMedit, printMedit},
        {{"Gmsh", {".msh"}, false, true, true, true, true}, readGmsh, printGmsh},
        {{"AVS UCD", {".inp"}, false, true, false, true, false}, readUcd, printUcd},
        {{"TetGen", {".node", ".ele"}, true, true, false, false, false}, readTetgen, printTetgen},
    };
    return formats;
}

const MeshFormat& formatOf(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    std::string known;
    for (const auto& format : meshFormats())
        for (const auto candidate : format.extensions) {
            if (sameWord(candidate, extension)) return format;
            known += " " + std::string(candidate);
        }
    const auto what = extension.empty() ? std::string("without an extension") : inQuotes(extension);
    throw InputError(path, "the mesh format is not known: " + what + " is none of" + known);
}

MeshFile readSources(const MeshFormat& format, std::span<const MeshSource> files) {
    try {
        MeshFile file = format.read(files);
        requireSound(file);
        return file;
    } catch (const InputError& error) {
        throw error.named(files[0].path);
    }
}

std::vector<std::string> printed(const MeshFormat& format, const MeshFile& mesh,
                                 const MeshWriteOptions& options) {
    requireSound(mesh);
    requireCarriable(format, mesh);
    if (!mesh.made && !options.boundary) return format.print(mesh, options);
    return format.print(asWritten(mesh, format, options), options);
}

}  // namespace wend::formats
