#pragma once

#include "core/mesh/skin.h"

namespace wend {
struct MeshFile;
}

namespace wend::formats {

/// Adds the texture points of corners, materials and groups to the skin of a file that readObj has read from
/// the same bytes, so that they are known to be sound.
void addObjLook(const std::string& bytes, const MeshFile& file, Skin& skin);

/// Returns the material files that an OBJ file names, and the pictures that those name.
std::vector<std::string> objLookFiles(const std::string& bytes, const std::string& path);

/// Returns the bytes of a skin's OBJ file with other vertices: its normals turn with the surface, and its
/// material files are named from `newFolder` instead of its own.
std::string withVertices(const std::string& bytes, const Skin& skin, const Points3& points,
                         const std::string& newFolder);

}  // namespace wend::formats
