#pragma once

#include <string_view>

#include "core/mesh/skin.h"

namespace wend::formats {

/// Adds the appearance of the surface in a binary glTF file to a skin: the texture point of every corner, and
/// the names and colours of its materials. The skin has the points and triangles that readGltf returns.
/// Throws InputError.
void addGltfLook(std::string_view bytes, Skin& skin);

}  // namespace wend::formats
