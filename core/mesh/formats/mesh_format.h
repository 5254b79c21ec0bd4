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

/// What a format holds of groups.
enum class GroupsHeld {
    None,
    Numbers,  // one for each cell
    Lists,    // and Medit's lists, such as Corners
    Names,    // one name for each cell
    All,      // any number of groups for a cell, with names
    Sets      // and of vertices
};
/// True for the names of Medit's lists.
bool isMeditList(std::string_view name);

/// One family of mesh files. To add a format: a reader and a printer in a file of their own and a row in
/// mesh_format.cpp.
struct MeshFormat : MeshFormatFacts {
    std::string_view article;  // "a " or "an "
    /// The bytes of one file, or of one of each extension; those after the pair may be empty. May throw
    /// InputError without the file's name.
    MeshFile (*read)(std::span<const MeshSource> files);
    /// The bytes of one file, or of one of each extension, of a bag (see bagOf) of kinds that it holds.
    std::vector<std::string> (*print)(const MeshFile& bag, const MeshWriteOptions& options);
    bool (*holds)(CellKind kind);
    GroupsHeld groups = GroupsHeld::None;
    bool holdsTexture = false, holdsColours = false, holdsFileFields = false;

    /// `isMain`: the group stands for some cell, see mainGroups.
    bool holdsGroup(const MeshGroup& group, bool isMain) const {
        if (groups >= GroupsHeld::All) return true;
        return (groups > GroupsHeld::None && isMain) || isList(group);
    }
    bool holdsNames(const MeshGroup& group) const { return groups >= GroupsHeld::Names || isList(group); }
    bool holdsNodeGroups(const MeshGroup& group) const { return groups == GroupsHeld::Sets || isList(group); }
    /// Returns whether a file may have vertices only.
    bool holdsPointsAlone() const;

  private:
    bool isList(const MeshGroup& group) const {
        return groups == GroupsHeld::Lists && isMeditList(group.name);
    }
};

const std::vector<MeshFormat>& meshFormats();
/// The format of a path by its extension. Throws InputError that lists what there is.
const MeshFormat& formatOf(const std::string& path);

/// readMeshFile and writeMeshFile without the file system. Throw InputError(file, reason).
MeshFile readSources(const MeshFormat& format, std::span<const MeshSource> files,
                     MeshNeeds needs = MeshNeeds::Cells);
std::vector<std::string> printed(const MeshFormat& format, const MeshFile& mesh,
                                 const MeshWriteOptions& options);

/// What of a mesh that was read a file of the format does not hold, in one line; empty if it holds all.
std::string lostIn(const MeshFormat& format, const MeshFile& mesh, const MeshWriteOptions& options);

/// A format that is read, but not written as a mesh.
struct InputFormat {
    std::string_view extension;
    MeshFile (*read)(std::span<const MeshSource> files);
};
const std::vector<InputFormat>& inputFormats();
/// readMeshFile of such a format without the file system. Throws InputError(file, reason).
MeshFile readSource(const InputFormat& format, const MeshSource& file, MeshNeeds needs);

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
std::vector<std::string> printVtp(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printUcd(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printAbaqus(const MeshFile& mesh, const MeshWriteOptions& options);
std::vector<std::string> printNastran(const MeshFile& mesh, const MeshWriteOptions& options);

}  // namespace wend::formats
