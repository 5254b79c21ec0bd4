#pragma once

#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_needs.h"
#include "core/mesh/mesh_write_options.h"
#include "core/mesh/skin.h"

namespace wend {

/// A surface with all that belongs to its look: of an OBJ file the texture points of every corner, materials
/// (.mtl) and groups; of other formats the texture point and fields of every vertex. Labels are the materials
/// of an OBJ file, or its groups if it has no materials, counted from 1; elsewhere a field "label", "ref",
/// "physical", "entity" or "attribute" of its triangles. Throws InputError. What an .mtl file names and is
/// missing is only a warning. With MeshNeeds::Points it may be points and polylines without triangles.
Skin readSkin(const std::string& path, MeshNeeds needs = MeshNeeds::Cells);

/// Returns the files of a surface's appearance: of an OBJ file its material libraries and their pictures,
/// existing or not; otherwise none, also for unreadable files.
std::vector<std::string> lookFilesOf(const std::string& path);

/// Writes the skin with its vertices at `points`, by extension: .glb, and the surface formats of
/// writeMeshFile. An OBJ file from an OBJ file keeps its polygons, texture, groups and materials; normals are
/// dropped, because they no longer match. `fields` (per vertex or triangle of the skin) are written if the
/// format supports them. Lines of the file go along. Throws InputError, also for a format that cannot hold
/// points without triangles if the skin has none.
void writeSkin(const std::string& path, const Skin& skin, const Points<3>& points,
               const std::vector<MeshField>& fields = {}, const MeshWriteOptions& options = {});

/// Throws InputError if the skin has no triangles and a file of that name needs some.
void requireSkinHeldBy(const std::string& path, const Skin& skin);

/// What of the skin's file would not be in one of that name, in one line; empty if all would be.
std::string lostInSkin(const std::string& path, const Skin& skin, const MeshWriteOptions& options);

/// The extensions that writeSkin knows, lower case, with the dot.
std::vector<std::string> skinFileExtensions();

}  // namespace wend
