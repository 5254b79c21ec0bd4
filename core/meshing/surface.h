#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/types.h"

namespace wend {

/// A triangle surface in space, as a soup with shared vertices. Order is the input's.
struct Surface {
    Points3 points;
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> labels;  // one per triangle, or empty

    int vertexCount() const { return static_cast<int>(points.cols()); }
    int triangleCount() const { return static_cast<int>(triangles.size()); }
};

/// Two connected components of a surface that touch, numbered from 1 in the order of their first triangles.
struct TouchingBodies {
    int first, second;
    bool alongAFace;  // else along an edge or at a point
    Vec3 place;       // where they do
    int pairs;        // of triangles that touch
};

/// Lists everything that prevents a surface from bounding a volume, so that it can be counted, shown and
/// saved.
struct SurfaceProblems {
    std::vector<int> notFinite;   // vertices with NaN or infinite coordinates
    std::vector<int> badIndex;    // triangles that name a missing vertex
    std::vector<int> degenerate;  // triangles without area, or that name a vertex twice
    std::vector<int> duplicate;   // triangles that repeat an earlier one
    std::vector<int> shared;  // triangles that face an earlier one at the same place: no fault, but a wall
                              // between bodies
    std::vector<std::array<int, 2>> openEdges;         // edges (vertices) of one triangle only
    std::vector<std::array<int, 2>> nonManifoldEdges;  // edges of more than two triangles
    std::vector<std::array<int, 2>>
        misoriented;  // edges that both neighbours run through in the same direction
    std::vector<std::array<int, 2>>
        intersecting;                      // pairs of triangles that cross; at most `limit` are listed
    std::vector<TouchingBodies> touching;  // whose triangles are among these, and do not cross
    int coincidentVertices = 0;            // vertices at the place of an earlier one
    bool flat = false;                     // all points in one plane

    /// Returns whether TetGen accepts the surface, which must be closed and free of crossings; orientation
    /// does not matter.
    bool boundsVolume() const;
    /// Returns one line: "12 open edges (first: 3–17), 4 pairs of triangles intersect (first: 20, 81)". Empty
    /// without problems.
    Message summary() const;
    /// Returns all triangles that are part of a problem, each once, in increasing order.
    std::vector<int> triangles(const Surface& surface) const;
};

/// Finds all problems. Crossings are exact (CGAL predicates); triangles that share a vertex or an edge also
/// count as crossing if they meet elsewhere. At most `limit` crossings are listed.
SurfaceProblems checkSurface(const Surface& surface, int limit = 10000);

/// Counts the repairs of a surface.
struct RepairReport {
    int steps = 0;  // of single faults, before (see surface_fixes.h)
    int mergedVertices = 0, droppedDegenerate = 0, droppedDuplicate = 0, flipped = 0, filledHoles = 0;
    int addedTriangles = 0;        // that fill them: the last of the surface
    std::vector<int> largerHoles;  // edges of each hole beyond the limit, the largest last
    Message summary() const;       // one line; empty if nothing was done
};

/// Does the simple repairs: merges coincident vertices, drops degenerate and duplicate triangles, orients
/// neighbours consistently, and closes holes of at most `largestHole` edges with a fan around their centre.
/// checkSurface reports what is still wrong.
Surface repairSurface(const Surface& surface, int largestHole, RepairReport& report);

}  // namespace wend
