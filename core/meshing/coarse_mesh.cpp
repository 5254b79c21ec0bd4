#include "core/meshing/coarse_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/mesh/boundary_loops.h"
#include "core/mesh/embedding.h"
#include "core/mesh/skin.h"
#include "core/meshing/cage.h"
#include "core/meshing/planar_mesher.h"

namespace wend {

namespace {

constexpr double kSameArea = 0.02;  // allowed change of area by simplification
// Fraction of the vertices around a coarse vertex that may be disconnected at the rim.
constexpr double kRim = 0.05;
constexpr int kMostAtRim = 2;

double areaOf(const SimplicialMesh<2>& mesh) {
    double area = 0;
    for (const Cell<2>& cell : mesh.cells) area += std::abs(cellMeasure<2>(mesh.points, cell));
    return area;
}

/// Returns whether the fine cells around some coarse vertex are disconnected: cells around one vertex move
/// almost alike, so that the cage would connect them. A few vertices at the rim of its cells may be
/// disconnected anyway.
bool joinsParts(const SimplicialMesh<3>& coarse, const SimplicialMesh<3>& fine) {
    const Embedding<3> places(coarse, fine.points);
    std::vector<std::vector<int>> verticesIn(coarse.cells.size());
    std::vector<std::vector<int>> coarseAround(static_cast<std::size_t>(coarse.vertexCount())),
        fineAround(static_cast<std::size_t>(fine.vertexCount()));
    for (int c = 0; c < coarse.cellCount(); ++c)
        for (const int v : coarse.cells[c]) coarseAround[v].push_back(c);
    for (int c = 0; c < fine.cellCount(); ++c)
        for (const int v : fine.cells[c]) fineAround[v].push_back(c);
    for (int v = 0; v < fine.vertexCount(); ++v)
        if (!fineAround[v].empty()) verticesIn[places.cell(v)].push_back(v);
    std::vector<int> number(fineAround.size(),
                            -1);  // of the vertices there, and those that share cells with them
    for (const std::vector<int>& star : coarseAround) {
        std::vector<int> within, all;
        for (const int c : star) within.insert(within.end(), verticesIn[c].begin(), verticesIn[c].end());
        const auto forNeighbours = [&](const auto& visit) {
            for (const int v : within)
                for (const int c : fineAround[v])
                    for (const int other : fine.cells[c]) visit(v, other);
        };
        forNeighbours([&](int, int other) {
            if (number[other] >= 0) return;
            number[other] = static_cast<int>(all.size());
            all.push_back(other);
        });
        DisjointSets sets(static_cast<int>(all.size()));
        forNeighbours([&](int v, int other) { sets.join(number[v], number[other]); });
        std::map<int, int> counts;
        for (const int v : within) ++counts[sets.root(number[v])];
        for (const int v : all) number[v] = -1;
        const double atRim = std::max<double>(kMostAtRim, kRim * static_cast<double>(within.size()));
        if (std::ranges::count_if(counts, [&](const auto& part) { return part.second > atRim; }) > 1)
            return true;
    }
    return false;
}

}  // namespace

template <>
SimplicialMesh<2> coarseMesh<2>(const SimplicialMesh<2>& fine, int vertices, std::stop_token stop) {
    const double area = areaOf(fine);
    PlanarMeshOptions options;
    options.vertices = vertices;
    options.simplify = std::sqrt(area / vertices);
    options.stop = stop;
    SimplicialMesh<2> coarse = meshOutline({boundaryLoops(fine)}, options);
    if (std::abs(areaOf(coarse) - area) > kSameArea * area)
        throw InputError("the shape covers itself at rest: its outline does not tell where it is");
    return coarse;
}

template <>
SimplicialMesh<3> coarseMesh<3>(const SimplicialMesh<3>& fine, int vertices, std::stop_token stop) {
    const Skin boundary = boundaryOf(fine);
    CageOptions options;
    options.vertices = vertices;
    options.stop = stop;
    SimplicialMesh<3> coarse = fitCage({boundary.points, boundary.triangles, {}}, options).mesh;
    if (joinsParts(coarse, fine)) throw InputError("so large cubes hold together what is apart");
    return coarse;
}

}  // namespace wend
