#pragma once

#include <string>
#include <vector>

#include "core/mesh/types.h"

namespace wend {

/// A surface for glTF 2.0: triangles, optional texture coordinates, and poses in time.
struct GltfScene {
    std::string name = "shape";
    std::vector<std::array<int, 3>> triangles;
    Points<3> points;              // what is shown without animation
    Eigen::Matrix2Xd uv;           // per vertex, origin at the bottom left; empty if there is none
    std::string texture;           // path of a PNG or JPEG to embed; empty if there is none
    std::vector<double> times;     // seconds, increasing; one per pose
    std::vector<Points<3>> poses;  // become morph targets that a weights animation shows one after another
};

/// Writes a binary glTF file (.glb), whole or not at all. y is up in glTF: z-up coordinates are turned if
/// `zUp`. Normals are left to the reader, so that they fit every pose. Throws InputError.
void writeGltf(const std::string& path, const GltfScene& scene, bool zUp = true);

}  // namespace wend
