#pragma once

#include <string>
#include <vector>

#include "core/mesh/simplicial_mesh.h"

namespace wend {

/// The appearance of a part of a surface.
struct SkinMaterial {
    std::string name;
    std::array<float, 4> colour{0.8F, 0.8F, 0.8F, 1};
    std::string texture;  // path of a picture; empty for none
};

/// The visible and exported surface of a solid: the surface that it was made from, a detailed embedded one,
/// or its boundary.
struct Skin {
    Points3 points;
    std::vector<std::array<int, 3>> triangles;
    /// Texture points, origin at the bottom left, and which of them the corners of each triangle have; both
    /// empty if there is no texture, the second as long as `triangles` otherwise.
    Eigen::Matrix2Xd uv;
    std::vector<std::array<int, 3>> uvCorners;
    std::vector<int> materialOf;  // per triangle, into materials (−1: none); empty if there are none
    std::vector<SkinMaterial> materials;
    std::vector<std::array<double, 4>> colours;  // per vertex, from 0 to 1 (sRGB); empty if there are none
    std::vector<int> labels;                     // per triangle; empty if there are none
    std::vector<std::string> labelNames;         // names of the labels 1, 2, …, if they have some
    std::string path;                            // the source file; empty for a boundary
    std::vector<std::string> warnings;           // missing files that it names

    int vertexCount() const { return static_cast<int>(points.cols()); }
};

/// Returns the boundary of a solid, oriented outwards where its cells are positive, with only the vertices on
/// it. Vertices keep their order, and triangles have that of the cells behind them.
Skin boundaryOf(const SimplicialMesh<3>& mesh);

/// A skin with one texture coordinate per vertex, as GPUs and glTF require.
struct UnfoldedSkin {
    std::vector<int> vertices;  // the skin's vertex of each
    Eigen::Matrix2Xd uv;        // empty if there is no texture
    std::vector<std::array<int, 3>> triangles;
};
/// Returns a skin in which vertices are doubled where several texture points meet; the others keep their
/// order.
UnfoldedSkin unfolded(const Skin& skin);

/// Returns unit normals of the vertices, weighted by the corners' angles; zero at vertices without a
/// triangle. The weights (Thürmer and Wüthrich 1998) make the result independent of how flat parts are
/// triangulated.
Points3 vertexNormals(const Points3& points, const std::vector<std::array<int, 3>>& triangles);

}  // namespace wend
