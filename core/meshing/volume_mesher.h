#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/simplicial_mesh.h"
#include "core/meshing/mesher_process.h"
#include "core/meshing/shell_spaces.h"
#include "core/meshing/surface.h"

namespace wend {

/// Relative edge lengths, as factors on a regular grid over the surface's box, with trilinear interpolation.
struct SizeGrid {
    Vec3 low = Vec3::Zero(), spacing = Vec3::Ones();
    std::array<int, 3> counts{};  // of nodes, x running fastest; 0: the same everywhere
    std::vector<double> factors;

    bool empty() const { return factors.empty(); }
};

/// Samples a function at about 50 nodes along the longest side of the surface's box.
SizeGrid sampleSizes(const Surface& surface, const std::function<double(const Vec3&)>& factorAt);

/// The options of meshVolume().
struct VolumeMeshOptions {
    double quality = 1.414;  // largest radius-edge ratio, ≥ 1.2 (TetGen's -q; near 1 it never ends)
    double maxVolume = 0;    // > 0: maximum volume of a cell, in the surface's units cubed; at a kept
                             // surface coarser than that, cells stay larger
    int vertices = 0;  // that cells have; > 0: aim, met within 15 % if the kept surface allows it; maxVolume
                       // then does not count
    bool keepSurface = true;  // the input's vertices and triangles stay as they are (-Y)
    Shells shells = Shells::Automatic;
    std::vector<std::string> labelNames;  // of the surface's labels 1, 2, …, by which spaces are named
    SizeGrid sizes;                       // volumes are proportional to the factor's cube
    double timeLimit = 120;  // seconds of computing, for each 50 000 triangles of the surface that it begins
    std::stop_token stop;
};

/// The mesh of a volume, with its boundary.
struct VolumeMesh {
    SimplicialMesh<3> mesh;                    // with keepSurface, vertices 0 … n−1 are the surface's
    std::vector<std::array<int, 3>> boundary;  // the boundary triangles
    std::vector<int> boundaryLabels;           // label of the input triangle that contains each one
    ShellSpaces spaces;
    std::vector<int> cellLabels;  // the label of the space of each cell; empty if there is but one space
    bool aimMet = true;           // false: the surface alone has too many (or -Y allows too few) vertices

    /// Returns how many vertices cells have; of several at one place only one counts.
    int usedCount() const;
};

/// Thrown if the surface bounds no volume; `problems` lists why.
class SurfaceError : public InputError {
  public:
    SurfaceError(const Message& what, SurfaceProblems found) : InputError(what), problems(std::move(found)) {}
    /// Copies an error and adds the file's name.
    SurfaceError(const SurfaceError& other, const std::string& file)
        : InputError(other.named(file)), problems(other.problems) {}

    SurfaceProblems problems;
};

/// Meshes the volume between the shells of a closed surface (see Shells) with TetGen in the process
/// wend-tetgen, so that it cannot crash, block or exit Wend. Throws SurfaceError with the surface's problems
/// (checkSurface); InputError with these and TetGen's failure, or if time ran out; Cancelled.
VolumeMesh meshVolume(const Surface& surface, const VolumeMeshOptions& options);

}  // namespace wend
