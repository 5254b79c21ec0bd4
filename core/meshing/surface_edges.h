#pragma once

#include <vector>

#include "core/meshing/surface.h"

namespace wend {

/// An edge of a surface (vertices increasing) with the triangles that have it.
struct SurfaceEdge {
    std::array<int, 2> vertices;
    std::vector<int> triangles;
};

/// Returns the two vertices in increasing order.
std::array<int, 2> sorted(int a, int b);

/// Returns the edges of a loop of vertices, each in increasing order.
std::vector<std::array<int, 2>> sidesOf(const std::vector<int>& loop);

/// Returns whether a side of a triangle runs from one vertex to the other.
bool runsAlong(const std::array<int, 3>& triangle, int from, int to);

/// Returns all edges in increasing order of their vertices. Triangles with invalid indices are skipped.
std::vector<SurfaceEdge> edgesOf(const Surface& surface);

/// Returns for each vertex the first one at the same place (bit for bit; itself if there is none).
std::vector<int> canonicalVertices(const Points3& points);

}  // namespace wend
