#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_formats.h"

namespace wend::formats {

/// An input file: its path, and its content.
struct MeshSource {
    std::string path;
    std::string bytes;
};

/// Says which groups a format holds.
enum class GroupsHeld {
    None,
    Numbers,  // one for each cell
    Lists,    // and Medit's lists, such as Corners
    Names,    // one name for each cell
    All,      // any number of groups for a cell, with names
    Sets      // and of vertices
};
/// Returns whether a name is that of one of Medit's lists.
bool isMeditList(std::string_view name);

/// One family of mesh files. A new format needs a reader and a printer in a file of their own, and a row in
/// mesh_format.cpp.
struct MeshFormat : MeshFormatFacts {
    std::string_view article;  // "a " or "an "
    /// Reads the bytes of one file, or of one of each extension; those after the pair may be empty. May throw
    /// InputError without the file's name.
    MeshFile (*read)(std::span<const MeshSource> files);
    /// Returns the bytes of one file, or of one of each extension, for a bag (see bagOf) of kinds that it
    /// holds.
    std::vector<std::string> (*print)(const MeshFile& bag, const MeshWriteOptions& options);
    bool (*holds)(CellKind kind);
    GroupsHeld groups = GroupsHeld::None;
    bool holdsTexture = false, holdsColours = false, holdsFileFields = false;
    bool holdsFaceColours = false, holdsNormals = false;  // where fields are not held

    /// Returns whether a file holds a group; `isMain` says that the group represents some cell, see
    /// mainGroups.
    bool holdsGroup(const MeshGroup& group, bool isMain) const {
        if (groups >= GroupsHeld::All) return true;
        return (groups > GroupsHeld::None && isMain) || isList(group);
    }
    /// Returns whether a file holds the name of a group.
    bool holdsNames(const MeshGroup& group) const { return groups >= GroupsHeld::Names || isList(group); }
    /// Returns whether a file holds a group of vertices.
    bool holdsNodeGroups(const MeshGroup& group) const { return groups == GroupsHeld::Sets || isList(group); }
    /// Returns whether a file may have vertices only.
    bool holdsPointsAlone() const;

  private:
    bool isList(const MeshGroup& group) const {
        return groups == GroupsHeld::Lists && isMeditList(group.name);
    }
};

/// Returns the table of formats.
const std::vector<MeshFormat>& meshFormats();
/// Returns the format of a path by its extension. Throws InputError that lists the known ones.
const MeshFormat& formatOf(const std::string& path);

/// Do the work of readMeshFile and writeMeshFile without the file system. Throw InputError(file, reason).
MeshFile readSources(const MeshFormat& format, std::span<const MeshSource> files,
                     MeshNeeds needs = MeshNeeds::Cells);
std::vector<std::string> printed(const MeshFormat& format, const MeshFile& mesh,
                                 const MeshWriteOptions& options);

/// Describes in one line what a file of the format does not hold of a mesh that was read; empty if it holds
/// everything.
std::string lostIn(const MeshFormat& format, const MeshFile& mesh, const MeshWriteOptions& options);

/// Returns the same for a binary glTF file, which holds triangles with their texture.
std::string lostInGltf(const MeshFile& mesh, const MeshWriteOptions& options);

/// A format that is read, but not written as a mesh.
struct InputFormat {
    std::string_view extension;
    MeshFile (*read)(std::span<const MeshSource> files);
};
/// Returns the table of these formats.
const std::vector<InputFormat>& inputFormats();
/// Does the work of readMeshFile for such a format, without the file system. Throws InputError(file, reason).
MeshFile readSource(const InputFormat& format, const MeshSource& file, MeshNeeds needs);

/// Readers: take the bytes of one file, or of one per extension in the format's order, and return the mesh,
/// with the file's order of vertices and cells. They may return indices out of range and coordinates that are
/// not finite; readSources() refuses these. Throw InputError that begins with the line or the byte offset and
/// may lack the file's name.
MeshFile readGltf(std::span<const MeshSource> files);
MeshFile readThreeMf(std::span<const MeshSource> files);
MeshFile readObj(std::span<const MeshSource> files);
MeshFile readPly(std::span<const MeshSource> files);
MeshFile readOff(std::span<const MeshSource> files);
MeshFile readStl(std::span<const MeshSource> files);
MeshFile readMedit(std::span<const MeshSource> files);
MeshFile readGmsh(std::span<const MeshSource> files);
MeshFile readTetgen(std::span<const MeshSource> files);
MeshFile readVtk(std::span<const MeshSource> files);
MeshFile readVtu(std::span<const MeshSource> files);
MeshFile readVtp(std::span<const MeshSource> files);
MeshFile readUcd(std::span<const MeshSource> files);
MeshFile readAbaqus(std::span<const MeshSource> files);
MeshFile readNastran(std::span<const MeshSource> files);
MeshFile readFoam(std::span<const MeshSource> files);
MeshFile readMed(std::span<const MeshSource> files);
MeshFile readXdmf(std::span<const MeshSource> files);
MeshFile readExodus(std::span<const MeshSource> files);
MeshFile readCgns(std::span<const MeshSource> files);

/// Printers: return the bytes of one file, or of one per extension in the format's order, for a bag (see
/// bagOf) that asHeld() has fitted to the format. Numbers read back as the same doubles, or as floats in the
/// encodings that say so. Throw InputError for cells that the format cannot hold.
std::vector<std::string> printObj(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printPly(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printOff(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printStl(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printMedit(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printGmsh(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printTetgen(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printVtk(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printVtu(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printVtp(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printUcd(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printAbaqus(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printNastran(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printFoam(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printMed(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printXdmf(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printExodus(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printCgns(const MeshFile& mesh, const MeshWriteOptions& options);

}  // namespace wend::formats
