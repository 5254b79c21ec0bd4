#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_formats.h"

namespace wend::formats {

struct MeshSource {
    std::string path;
    std::string bytes;
};

/// One family of mesh files. To add a format: a reader and a printer in a file of their own and a row in
/// mesh_format.cpp.
struct MeshFormat : MeshFormatFacts {
    /// The bytes of one file, or of one of each extension. May throw InputError without the file's name.
    MeshFile (*read)(std::span<const MeshSource> files);
    /// The bytes of one file, or of one of each extension.
    std::vector<std::string> (*print)(const MeshFile& mesh, const MeshWriteOptions& options);
};

const std::vector<MeshFormat>& meshFormats();
/// The format of a path by its extension. Throws InputError that lists what there is.
const MeshFormat& formatOf(const std::string& path);

/// readMeshFile and writeMeshFile without the file system. Throw InputError(file, reason).
MeshFile readSources(const MeshFormat& format, std::span<const MeshSource> files);
std::vector<std::string> printed(const MeshFormat& format, const MeshFile& mesh,
                                 const MeshWriteOptions& options);

/// Readers: return the content of the files, with the order and number of vertices and cells, all indices
/// valid and all numbers finite. The reader of TetGen takes a .node and an .ele file, the others one. Throw
/// InputError("", reason with line, byte or cell) for damaged content and unsupported cells.
MeshFile readObj(std::span<const MeshSource> files);
MeshFile readPly(std::span<const MeshSource> files);
MeshFile readOff(std::span<const MeshSource> files);
MeshFile readStl(std::span<const MeshSource> files);
MeshFile readMedit(std::span<const MeshSource> files);
MeshFile readGmsh(std::span<const MeshSource> files);
MeshFile readTetgen(std::span<const MeshSource> files);
MeshFile readVtk(std::span<const MeshSource> files);
MeshFile readVtu(std::span<const MeshSource> files);
MeshFile readUcd(std::span<const MeshSource> files);

/// Printers: return the bytes of one file, or of one per extension in the format's order. Numbers read back
/// as the same doubles, or as floats in the encodings that say so. Throw InputError for cells that the format
/// cannot hold.
std::vector<std::string> printObj(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printPly(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printOff(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printStl(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printMedit(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printGmsh(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printTetgen(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printVtk(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printVtu(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printUcd(const MeshFile& mesh, const MeshWriteOptions& options);

}  // namespace wend::formats
