#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/mesh/error.h"
#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/mesher_process.h"
#include "core/meshing/surface.h"

namespace wend {

/// How long edges are to be relative to elsewhere: factors on a regular grid over the surface's box,
/// trilinear between.
struct SizeGrid {
    Vec<3> low = Vec<3>::Zero(), spacing = Vec<3>::Ones();
    std::array<int, 3> counts{};  // of nodes, x running fastest; 0: the same everywhere
    std::vector<double> factors;

    bool empty() const { return factors.empty(); }
};

/// The function at about 50 nodes along the longest side of the surface's box.
SizeGrid sampleSizes(const Surface& surface, const std::function<double(const Vec<3>&)>& factorAt);

struct VolumeMeshOptions {
    double quality = 1.414;  // largest radius-edge ratio, ≥ 1.2 (TetGen's -q; near 1 it never ends)
    double maxVolume = 0;    // > 0: maximum volume of a cell, in the surface's units cubed; at a kept
                             // surface coarser than that, cells stay larger
    int vertices = 0;  // that cells have; > 0: aim, met within 15 % if the kept surface allows it; maxVolume
                       // then does not count
    bool keepSurface = true;  // the input's vertices and triangles stay as they are (-Y)
    SizeGrid sizes;           // volumes go with the factor's cube
    double timeLimit = 120;   // seconds of computing, for each 50 000 triangles of the surface that it begins
    std::stop_token stop;
};

struct VolumeMesh {
    SimplicialMesh<3> mesh;                    // with keepSurface, vertices 0 … n−1 are the surface's
    std::vector<std::array<int, 3>> boundary;  // the boundary triangles
    std::vector<int> boundaryLabels;           // the label of the input triangle that each one lies in
    bool aimMet = true;  // false: the surface alone has too many (or -Y allows too few) vertices

    /// Vertices that cells have: of several at one place only one is among them.
    int usedCount() const;
};

/// The surface bounds no volume; `problems` lists why.
class SurfaceError : public InputError {
  public:
    SurfaceError(const std::string& what, SurfaceProblems found)
        : InputError(what), problems(std::move(found)) {}
    /// The same with the file's name.
    SurfaceError(const SurfaceError& other, const std::string& file)
        : InputError(other.named(file)), problems(other.problems) {}

    SurfaceProblems problems;
};

/// The volume between the shells of a closed surface (inside where an odd number of shells encloses: a shell
/// in a shell is a hole), by TetGen in a process of its own (wend-tetgen beside the program): it can neither
/// crash, hang nor exit Wend. Throws SurfaceError: what is wrong with the surface (checkSurface); InputError:
/// that and how TetGen failed, or that time ran out; Cancelled.
VolumeMesh meshVolume(const Surface& surface, const VolumeMeshOptions& options);

}  // namespace wend
