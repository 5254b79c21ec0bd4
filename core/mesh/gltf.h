#pragma once

#include <string>
#include <vector>

#include "core/mesh/skin.h"

namespace wend {

/// A surface for glTF 2.0: triangles, optional texture coordinates, and poses in time.
struct GltfScene {
    std::string name = "shape";
    std::vector<std::array<int, 3>> triangles;
    Points3 points;                              // the unanimated pose
    Eigen::Matrix2Xd uv;                         // per vertex, origin at the bottom left; empty for none
    std::vector<std::array<double, 4>> colours;  // per vertex, as those of a skin; empty for none
    std::string texture;                         // path of a PNG or JPEG to embed; empty for none
    std::vector<int> materialOf;  // per triangle, into materials (−1: none); empty: one material
    std::vector<SkinMaterial> materials;
    bool smooth = false;         // with normals, in every pose; else the reader shades facets
    bool isUnlit = false;        // textures show their own colours, and their alpha (KHR_materials_unlit)
    std::vector<double> times;   // seconds, increasing; one per pose
    std::vector<Points3> poses;  // become morph targets that a weights animation shows one after another
};

/// Returns a skin in a pose as a scene. Vertices are doubled where texture points meet.
GltfScene gltfScene(const Skin& skin, const Points3& points);
/// Returns a skin in several poses of its vertices, from the first one on, as an animated scene.
GltfScene gltfScene(const Skin& skin, const std::vector<Points3>& poses, std::vector<double> times);

/// Writes a binary glTF file (.glb), whole or not at all. In glTF y is up: z-up coordinates are rotated if
/// `zUp`. A picture that is neither PNG nor JPEG is left out. Throws InputError.
void writeGltf(const std::string& path, const GltfScene& scene, bool zUp = true);

}  // namespace wend
