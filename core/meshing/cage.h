#pragma once

#include <stop_token>

#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/closed_gaps.h"
#include "core/meshing/mesher_process.h"
#include "core/meshing/surface.h"

namespace wend {

/// The options of fitCage().
struct CageOptions {
    int vertices = 5000;   // aim, met within 15 % where whole cubes allow it
    double maxVolume = 0;  // > 0: maximum volume of a cell; the aim then does not count
    double detail = 0;     // > 0: gaps and holes narrower than the diagonal / (20 detail) are closed; 0: as
                           // narrow as the cells
    double offset = 1.0 / 15;  // how far the cage reaches beyond the surface at least, relative to that width
                               // or else to the cubes
    std::stop_token stop;
};

/// A closed body of even cells around any set of triangles.
struct Cage {
    SimplicialMesh<3> mesh;
    double edge = 0;              // of the cubes that the cells are made of
    bool aimMet = true;           // false: whole cubes, or the memory for them, allow nothing nearer
    int bodies = 0;               // that are connected through faces
    int parts = 0;                // of the surface
    int apart = 0;                // sets of parts that share no cube: `parts` if none moves with another
    std::vector<ClosedGap> gaps;  // within parts, that it closes, the narrowest first
    double openEdge = 0;          // > 0: the edge length of cubes that keep the widest gap open …
    double openDetail = 0;        // … and the detail; 0 if the current value suffices
};

/// Builds a cage of equal cubes that covers the surface and its inside (see fullCubes). Each cube is split
/// into tetrahedra between its centre, its neighbours' centres and the corners: a few shapes, none worse than
/// a quarter of a cube. Every triangle is inside, whether the surface is closed, crosses itself, or is a set
/// of loose parts. It is computed by wend-cage, a process beside the program, which can be killed at any
/// moment, and ends on its own if memory or time are insufficient. Throws InputError for that, and for
/// surfaces without a triangle or extent; MesherLost; Cancelled.
Cage fitCage(const Surface& surface, const CageOptions& options);

}  // namespace wend
