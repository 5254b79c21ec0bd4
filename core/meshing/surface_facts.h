#pragma once

#include <optional>

#include "core/meshing/surface.h"

namespace wend {

/// Basic facts about a surface. Coincident vertices count as one.
struct SurfaceFacts {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // bounding box of the triangles
    double area = 0;
    int edges = 0;
    double shortestEdge = 0, meanEdge = 0, longestEdge = 0;
    int parts = 0;             // that are connected through edges
    int boundaryLoops = 0;     // boundaries of holes
    int sides = 0;             // 1 of a Möbius band, 2; 0 where more than two triangles meet at an edge
    std::optional<int> genus;  // handles of all parts together, if it has two sides
    int deepest = 0;           // shells around one place, where every edge is run along in both directions
    std::optional<double> volume;  // enclosed, shells in an odd number of others being holes; if every
                                   // edge is run along as often in both directions
};

/// Computes the facts of a surface whose indices are valid and whose coordinates are finite. It does not look
/// for crossings.
SurfaceFacts factsOf(const Surface& surface);

}  // namespace wend
