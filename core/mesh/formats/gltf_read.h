#pragma once

#include <string_view>

#include "core/mesh/skin.h"

namespace wend::formats {

/// Adds what a binary glTF file says of the look of its surface: the texture point of every corner, and the
/// names and colours of its materials. The skin has the points and triangles that readGltf gives. Throws
/// InputError.
void addGltfLook(std::string_view bytes, Skin& skin);

}  // namespace wend::formats
