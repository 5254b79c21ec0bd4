#pragma once

#include <stop_token>

#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/closed_gaps.h"
#include "core/meshing/mesher_process.h"
#include "core/meshing/surface.h"

namespace wend {

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
    double openEdge = 0;          // > 0: with such cubes the widest of them stays open …
    double openDetail = 0;        // … and with this detail: either may do as it is, which is 0
};

/// Cubes of one size that cover the surface and what it encloses (see fullCubes), each filled with
/// tetrahedra between its middle, its neighbours' middles and the corners: all of a few shapes, none worse
/// than a quarter of a cube. Every triangle lies inside, whether the surface is closed, crosses itself, or
/// is a heap of loose parts. It is made in a process of its own (wend-cage beside the program), which can be
/// stopped at any moment, and alone ends where memory or time do not suffice. Throws InputError: that, or no
/// triangle, or no extent; MesherLost; Cancelled.
Cage fitCage(const Surface& surface, const CageOptions& options);

}  // namespace wend
