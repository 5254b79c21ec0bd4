#pragma once

#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_needs.h"
#include "core/mesh/mesh_write_options.h"
#include "core/mesh/skin.h"

namespace wend {

/// Reads a surface with its appearance. An OBJ file gives the texture points of every corner, materials
/// (.mtl) and groups; other formats give the texture point and fields of every vertex. Labels are the
/// materials of an OBJ file, or its groups if it has no materials, counted from 1; elsewhere they are a field
/// "label", "ref", "physical", "entity" or "attribute" of its triangles. Throws InputError. A missing file
/// that an .mtl file names is only a warning. With MeshNeeds::Points the surface may consist of points and
/// polylines without triangles.
Skin readSkin(const std::string& path, MeshNeeds needs = MeshNeeds::Cells);

/// Returns the files of a surface's appearance: of an OBJ file its material libraries and their pictures,
/// existing or not; otherwise none, also for unreadable files.
std::vector<std::string> lookFilesOf(const std::string& path);

/// Writes the skin with its vertices at `points`, by extension: .glb, and the surface formats of
/// writeMeshFile. An OBJ file from an OBJ file keeps its polygons, texture, groups and materials; normals
/// turn with the surface. `fields` (per vertex or triangle of the skin) are written if the format supports
/// them, and so are lines of the skin's file. Throws InputError, also for a format that cannot hold points
/// without triangles if the skin has none.
void writeSkin(const std::string& path, const Skin& skin, const Points3& points,
               const std::vector<MeshField>& fields = {}, const MeshWriteOptions& options = {});

/// Throws InputError if the skin has no triangles and a file of that name needs some.
void requireSkinHeldBy(const std::string& path, const Skin& skin);

/// Describes in one line what a file of that name would not hold of the skin's file; empty if it would hold
/// everything.
std::string lostInSkin(const std::string& path, const Skin& skin, const MeshWriteOptions& options);

/// Returns the extensions that writeSkin knows, in lower case, with the dot.
std::vector<std::string> skinFileExtensions();

}  // namespace wend
