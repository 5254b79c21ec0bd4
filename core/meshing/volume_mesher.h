#pragma once

#include <stop_token>
#include <vector>

#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/surface.h"

namespace wend {

struct VolumeMeshOptions {
    double quality = 1.414;  // greatest radius-edge ratio, ≥ 1.2 (TetGen's -q; near 1 it never ends)
    double maxVolume = 0;    // > 0: greatest volume of a cell, in the surface's units cubed; at a kept
                             // surface coarser than that, cells stay larger
    int vertices =
        0;  // > 0: aim, met within 15 % if the kept surface allows it; maxVolume then does not count
    bool keepSurface = true;  // the input's vertices and triangles stay as they are (-Y)
    double timeLimit = 120;   // seconds for one run of the mesher
    std::stop_token stop;
};

struct VolumeMesh {
    SimplicialMesh<3> mesh;                    // with keepSurface, vertices 0 … n−1 are the surface's
    std::vector<std::array<int, 3>> boundary;  // the boundary triangles
    std::vector<int> boundaryLabels;           // the label of the input triangle that each one lies in
    bool aimMet = true;  // false: the surface alone has too many (or -Y allows too few) vertices
};

/// The volume between the shells of a closed surface (inside where an odd number of shells encloses: a shell
/// in a shell is a hole), by TetGen in a process of its own (wend-tetgen beside the program): it can neither
/// crash, hang nor exit Wend. Throws InputError: what is wrong with the surface (checkSurface), or that and
/// how TetGen failed, or that time ran out.
VolumeMesh meshVolume(const Surface& surface, const VolumeMeshOptions& options);

}  // namespace wend
