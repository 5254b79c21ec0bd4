#pragma once

#include <QColor>
#include <vector>

#include "core/mesh/cut_plane.h"
#include "core/mesh/embedding.h"
#include "core/mesh/skin.h"

namespace wend {

/// The drawable form of a surface, made once and moved by poses: points, their vertices (several at creases
/// and texture seams), and triangles.
struct DrawMesh {
    struct Vertex {
        int point, normal;  // of `points` of the pose; which of the normals
    };
    struct Part {
        int first, count;  // triangles
        int material;      // of the skin; −1: none
    };
    std::vector<std::array<int, 3>> triangles;  // points
    std::vector<std::array<int, 3>> corners;    // vertices
    std::vector<Vertex> vertices;
    std::vector<Eigen::Vector2f> uv;  // of the vertices; empty if there is no texture
    std::vector<QRgb> tints;          // of the vertices; empty if the skin has no colours of vertices
    std::vector<int> cells;           // per triangle: the cell behind
    std::vector<QRgb> colours;        // per triangle: of its material; empty without materials
    std::vector<Part> parts;          // the triangles one after another
    int points = 0, normals = 0;
    std::vector<CutSurface::Corner> places;  // the points on the solid; empty if they are embedded in it
};

/// The points of a cut surface: its vertices and the crossings of its edges, each once.
struct CutPoints {
    std::vector<CutSurface::Corner> points;
    std::vector<std::array<int, 3>> triangles;

    explicit CutPoints(const CutSurface& surface);
    Points3 at(const Points3& pose) const;
};

/// Returns the border of a part of a surface: the edges of an odd number of its triangles, as pairs of
/// vertices.
std::vector<std::array<int, 2>> borderOf(const std::vector<std::array<int, 3>>& triangles);

/// Returns the part on the cut, or the rest.
CutSurface partOf(const CutSurface& surface, bool onCut);

/// Makes the surface of a solid, cut or not. Creases are those of the rest shape; the cut is flat.
DrawMesh drawMesh(const CutSurface& surface, const Points3& rest);
/// Makes the section of an exact cut, a plane with a single normal regardless of slivers.
DrawMesh drawSection(const CutSurface& section);
/// Returns the mesh of a surface embedded in a solid, with its texture points and materials.
DrawMesh drawMesh(const Skin& skin, const Embedding<3>& embedding);

/// Returns whether a skin has materials, or colours of vertices.
bool hasOwnColours(const Skin& skin);

/// Returns the points of a solid's surface in a pose.
Points3 drawnPoints(const DrawMesh& mesh, const Points3& pose);
/// Returns the normal of every vertex: the mean, by area, of the triangles that share it smoothly.
std::vector<Eigen::Vector3f> drawnNormals(const DrawMesh& mesh, const Eigen::Matrix3Xf& points);

}  // namespace wend
