#pragma once

#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// An edge of a surface (vertices increasing) with the triangles that have it.
struct SurfaceEdge {
    std::array<int, 2> vertices;
    std::vector<int> triangles;
};

/// The two vertices in increasing order.
std::array<int, 2> sorted(int a, int b);

/// The edges of a loop of vertices, each in increasing order.
std::vector<std::array<int, 2>> sidesOf(const std::vector<int>& loop);

/// Whether a side of a triangle goes from one vertex to the other.
bool runsAlong(const std::array<int, 3>& triangle, int from, int to);

/// All edges, in increasing order of their vertices. Triangles with bad indices are passed over.
std::vector<SurfaceEdge> edgesOf(const Surface& surface);

/// For each vertex the first vertex at the same place (bit for bit; itself if there is none).
std::vector<int> canonicalVertices(const Points<3>& points);

}  // namespace wend
