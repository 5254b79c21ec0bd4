#pragma once

#include "core/meshing/surface.h"

namespace wend {

/// The result of weldSeams().
struct SeamWeld {
    int vertices = 0;      // that were moved onto others
    double tolerance = 0;  // the widest gap that was closed
};

/// Closes seams: moves each vertex of an open edge onto the nearest one of another open edge, where both are
/// nearest to each other and closer than a thousandth of the surface's diagonal and a tenth of the shortest
/// open edge. Vertices at one place count as one. Nothing is done where that leaves as many open edges, or
/// edges of more than two triangles that there were not before. Of two vertices the one with the lower number
/// stays where it is. The triangles keep their vertices, which only come to be at one place.
SeamWeld weldSeams(Surface& surface);

}  // namespace wend
