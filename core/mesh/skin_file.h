#pragma once

#include "core/mesh/mesh_field.h"
#include "core/mesh/mesh_write_options.h"
#include "core/mesh/skin.h"

namespace wend {

/// A surface with all that belongs to its look: of an OBJ file the texture points of every corner, materials
/// (.mtl) and groups; of other formats the texture point and fields of every vertex. Labels are the materials
/// of an OBJ file, or its groups if it has no materials, counted from 1; elsewhere a field "label", "ref",
/// "physical", "entity" or "attribute" of its triangles. Throws InputError. What an .mtl file names and is
/// missing is only a warning.
Skin readSkin(const std::string& path);

/// What belongs to a surface's look and stands in files of its own: of an OBJ file its materials and their
/// pictures, there or not; otherwise none. Of a file that cannot be read none either.
std::vector<std::string> lookFilesOf(const std::string& path);

/// The skin with its vertices at `points`, by extension: .glb, and the surface formats of writeMeshFile. An
/// OBJ file that came from an OBJ file is that file with other vertices: its polygons, texture, groups and
/// materials stay, its normals, which are no longer true, go. `fields` (per vertex or triangle of the skin)
/// go where the format carries them. Throws InputError.
void writeSkin(const std::string& path, const Skin& skin, const Points<3>& points,
               const std::vector<MeshField>& fields = {}, const MeshWriteOptions& options = {});

/// The extensions that writeSkin knows, lower case, with the dot.
std::vector<std::string> skinFileExtensions();

}  // namespace wend
