#include "app/engine/shape/inspection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/mesh/hanging_parts.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/plane_frame.h"
#include "core/mesh/simplicial_mesh.h"
#include "core/mesh/skin.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/surface.h"

namespace wend {
namespace {

constexpr const char* kUnused = "vertices that no cell uses";

template <int Dim>
using Key = std::array<int, Dim>;

template <std::size_t N>
std::array<int, N> sorted(std::array<int, N> ids) {
    std::ranges::sort(ids);
    return ids;
}

template <int Dim>
bool repeatsVertex(const Cell<Dim>& cell) {
    const auto ids = sorted(cell);
    return std::ranges::adjacent_find(ids) != ids.end();
}

/// Returns the cells of each facet, by its sorted vertices.
template <int Dim>
std::map<Key<Dim>, std::vector<int>> cellsOfFacets(const std::vector<Cell<Dim>>& cells) {
    std::map<Key<Dim>, std::vector<int>> facets;
    for (int c = 0; c < static_cast<int>(cells.size()); ++c)
        for (int k = 0; k <= Dim; ++k) {
            Key<Dim> facet;
            for (int i = 0, at = 0; i <= Dim; ++i)
                if (i != k) facet[at++] = cells[c][i];
            facets[sorted(facet)].push_back(c);
        }
    return facets;
}

/// Counts the parts that are connected through facets.
template <int Dim>
int countParts(const std::map<Key<Dim>, std::vector<int>>& facets, int cells) {
    DisjointSets sets(cells);
    for (const auto& [facet, around] : facets)
        for (int cell : around) sets.join(cell, around.front());
    int parts = 0;
    for (int c = 0; c < cells; ++c) parts += sets.root(c) == c;
    return parts;
}

template <int Dim>
std::vector<int> duplicates(const std::vector<Cell<Dim>>& cells) {
    std::map<Cell<Dim>, int> first;
    std::vector<int> found;
    for (int c = 0; c < static_cast<int>(cells.size()); ++c)
        if (!first.emplace(sorted(cells[c]), c).second) found.push_back(c);
    return found;
}

template <int Dim>
std::vector<int> unusedVertices(const SimplicialMesh<Dim>& mesh) {
    const std::vector<bool> used = usedVertices<Dim>(mesh.vertexCount(), mesh.cells);
    std::vector<int> unused;
    for (int i = 0; i < mesh.vertexCount(); ++i)
        if (!used[i]) unused.push_back(i);
    return unused;
}

/// Returns the cells that are oriented against the majority.
template <int Dim>
std::vector<int> invertedCells(const SimplicialMesh<Dim>& mesh) {
    std::vector<int> positive, negative;
    for (int c = 0; c < mesh.cellCount(); ++c) {
        if (isFlat<Dim>(mesh.points, mesh.cells[c])) continue;
        (cellMeasure<Dim>(mesh.points, mesh.cells[c]) > 0 ? positive : negative).push_back(c);
    }
    return positive.size() < negative.size() ? positive : negative;
}

/// Returns the cells on the same side of the facet between them as a neighbour, however they are numbered.
template <int Dim>
std::vector<int> foldedCells(SimplicialMesh<Dim> mesh, const std::map<Key<Dim>, std::vector<int>>& facets) {
    for (const auto& [facet, around] : facets)
        if (around.size() > 2) return {};
    for (auto& cell : mesh.cells)
        if (cellMeasure<Dim>(mesh.points, cell) < 0) std::swap(cell[Dim - 1], cell[Dim]);
    std::vector<int> found;
    for (const auto& pair : foldedPairs<Dim>(mesh)) found.insert(found.end(), pair.begin(), pair.end());
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

template <int Dim>
std::vector<int> crowdedCells(const std::map<Key<Dim>, std::vector<int>>& facets) {
    std::vector<int> found;
    for (const auto& [facet, around] : facets)
        if (around.size() > 2) found.insert(found.end(), around.begin(), around.end());
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

template <int Dim, class Test>
std::vector<int> cellsWhere(const SimplicialMesh<Dim>& mesh, Test test) {
    std::vector<int> found;
    for (int c = 0; c < mesh.cellCount(); ++c)
        if (test(mesh.cells[c])) found.push_back(c);
    return found;
}

template <int Dim>
void findProblems(const SimplicialMesh<Dim>& mesh, const std::map<Key<Dim>, std::vector<int>>& facets,
                  MeshInspection& inspection) {
    const auto add = [&](const char* what, std::vector<int> where, bool fatal = true) {
        if (!where.empty()) inspection.problems.push_back({what, std::move(where), fatal});
    };
    const auto flat = [&](const Cell<Dim>& cell) {
        return !repeatsVertex<Dim>(cell) && isFlat<Dim>(mesh.points, cell);
    };
    add("cells that name a vertex twice", cellsWhere<Dim>(mesh, repeatsVertex<Dim>));
    add(Dim == 2 ? "cells without area" : "cells without volume", cellsWhere<Dim>(mesh, flat));
    add("cells that repeat an earlier one", duplicates<Dim>(mesh.cells));
    add("cells numbered against the others", invertedCells<Dim>(mesh), false);
    add("cells that overlap a neighbour", foldedCells<Dim>(mesh, facets));
    add(Dim == 2 ? "cells at edges of more than two" : "cells at faces of more than two",
        crowdedCells<Dim>(facets));
    add(kUnused, unusedVertices<Dim>(mesh), false);
}

/// Adds parts that are connected by vertices or edges only.
void addHanging(const std::vector<HangingPart>& parts, MeshInspection& inspection) {
    MeshProblem points{"vertices that a part hangs on alone", {}, false},
        lines{"edges that a part hangs on alone", {}, false};
    for (const HangingPart& part : parts)
        if (part.joint.size() == 1)
            points.where.push_back(part.joint[0]);
        else
            lines.pairs.push_back({part.joint.front(), part.joint.back()});
    for (const auto& problem : {points, lines})
        if (problem.count() > 0) inspection.problems.push_back(problem);
}

template <int Dim>
void inspectPartition(const SimplicialMesh<Dim>& mesh, MeshInspection& inspection) {
    const auto facets = cellsOfFacets<Dim>(mesh.cells);
    inspection.dimension = Dim;
    inspection.cells = mesh.cellCount();
    inspection.diagonal = extentOf<Dim>(mesh.points, mesh.cells).diagonal();
    inspection.parts = countParts<Dim>(facets, mesh.cellCount());
    inspection.quality = qualityOf<Dim>(mesh);
    findProblems<Dim>(mesh, facets, inspection);
    if (std::ranges::none_of(inspection.problems, &MeshProblem::fatal))
        addHanging(hangingParts<Dim>(mesh), inspection);
}

/// Returns whether squares or volumes of lengths overflow.
bool isBeyondNumbers(const Points3& points) {
    const double spread = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
    return spread > 0 && !(spread > 1e-100 && spread < 1e100);
}

std::vector<int> coincident(const Points3& points) {
    std::map<std::array<double, 3>, int> first;
    std::vector<int> found;
    for (int v = 0; v < static_cast<int>(points.cols()); ++v)
        if (!first.emplace(std::array{points(0, v), points(1, v), points(2, v)}, v).second)
            found.push_back(v);
    return found;
}

void inspectSurface(const MeshFile& file, MeshInspection& inspection) {
    inspection.diagonal = boundingBoxDiagonal<3>(file.points);
    const auto edges = cellsOfFacets<2>(file.triangles);
    inspection.parts = countParts<2>(edges, static_cast<int>(file.triangles.size()));
    const Surface surface{file.points, file.triangles, {}};
    inspection.facts = factsOf(surface);
    const SurfaceProblems found = checkSurface(surface);
    inspection.surface = found.summary();
    inspection.suspects = found.triangles(surface);
    inspection.faults = faultsOf(surface, found);
    if (found.notFinite.empty()) inspection.intersectingPairs = static_cast<int>(found.intersecting.size());
    if (found.boundsVolume()) inspection.volume = inspection.facts->volume.value_or(0);
    const auto add = [&](const char* what, const std::vector<int>& where) {
        if (!where.empty()) inspection.problems.push_back({what, where, true});
    };
    const auto addPairs = [&](const char* what, const std::vector<std::array<int, 2>>& pairs, bool fatal) {
        if (!pairs.empty()) inspection.problems.push_back({what, {}, fatal, pairs});
    };
    if (found.flat) inspection.problems.push_back({"all points lie in one plane", {}, true});
    addPairs("open edges", found.openEdges, true);
    addPairs("edges of more than two triangles", found.nonManifoldEdges, false);
    addPairs("pairs of triangles that intersect", found.intersecting, true);
    std::vector<std::array<int, 2>> touching;
    for (const TouchingBodies& one : found.touching) touching.push_back({one.first, one.second});
    addPairs("bodies that touch where their triangles do not match", touching, false);
    add("triangles without area", found.degenerate);
    add("duplicate triangles", found.duplicate);
    if (!found.shared.empty())
        inspection.problems.push_back({"triangles that bodies share as a wall", found.shared, false});
    addPairs("edges where the orientation changes", found.misoriented, false);
    addHanging(hangingParts(file.points, file.triangles), inspection);
    if (found.coincidentVertices > 0)
        inspection.problems.push_back(
            {"vertices at the place of an earlier one", coincident(file.points), false});
}

/// Takes vertices off the list of unused ones that the file's own cells use, as between corners.
void forgetNodes(const MeshFile& file, std::vector<MeshProblem>& problems) {
    std::vector<bool> used(static_cast<std::size_t>(file.points.cols()), false);
    for (const int v : file.cells.nodes) used[static_cast<std::size_t>(v)] = true;
    for (MeshProblem& problem : problems)
        if (problem.what == kUnused)
            std::erase_if(problem.where, [&](int v) { return used[static_cast<std::size_t>(v)]; });
    std::erase_if(problems, [](const MeshProblem& problem) {
        return problem.what == kUnused && problem.where.empty();
    });
}

void collectSuspects(MeshInspection& inspection) {
    for (const MeshProblem& problem : inspection.problems)
        if (problem.fatal)
            inspection.suspects.insert(inspection.suspects.end(), problem.where.begin(), problem.where.end());
    std::ranges::sort(inspection.suspects);
    const auto rest = std::ranges::unique(inspection.suspects);
    inspection.suspects.erase(rest.begin(), rest.end());
}

template <std::size_t N>
void takeSuspects(const std::vector<std::array<int, N>>& cells, const std::vector<int>& suspects,
                  std::vector<int>& newId, std::vector<std::array<int, N>>& taken, MeshFile& file) {
    MeshField numbers{"cell", true, 1, {}};
    for (int c : suspects) {
        taken.push_back(cells[c]);
        numbers.values.push_back(c);
        for (int v : cells[c]) newId[v] = 0;
    }
    file.fields.push_back(std::move(numbers));
}

/// 1 for each suspect that takes part in this.
MeshField tagsOf(const FaultKind& kind, const std::vector<int>& suspects) {
    MeshField tags{kind.name, true, 1, std::vector<double>(suspects.size(), 0.0)};
    for (const auto& one : kind.cases)
        for (const int t : one)
            tags.values[static_cast<std::size_t>(std::ranges::lower_bound(suspects, t) - suspects.begin())] =
                1;
    return tags;
}

}  // namespace

MeshInspection inspectFile(const std::string& path) {
    return inspect(readMeshFile(path));
}

MeshInspection inspect(const MeshFile& file) {
    MeshInspection inspection;
    inspection.vertices = static_cast<int>(file.points.cols());
    inspection.triangles = static_cast<int>(file.triangles.size());
    if (isBeyondNumbers(file.points)) {
        inspection.problems.push_back({"too large or too small to compute with", {}, true});
    } else if (isVolume(file)) {
        inspectPartition<3>({file.points, file.tetrahedra}, inspection);
        if (std::ranges::none_of(inspection.problems, &MeshProblem::fatal)) {
            const Skin boundary = boundaryOf({file.points, file.tetrahedra});
            inspection.facts = factsOf({boundary.points, boundary.triangles, {}});
        }
    } else if (const auto plane = planeOf(file.points, file.triangles)) {
        inspectPartition<2>({plane->toPlane(file.points).topRows<2>(), file.triangles}, inspection);
    } else {
        inspectSurface(file, inspection);
    }
    forgetNodes(file, inspection.problems);
    if (inspection.dimension > 0) collectSuspects(inspection);
    return inspection;
}

void writeSuspects(const std::string& path, const MeshFile& file, const MeshInspection& inspection) {
    MeshFile result;
    std::vector<int> newId(static_cast<std::size_t>(file.points.cols()), -1);
    if (isVolume(file))
        takeSuspects(file.tetrahedra, inspection.suspects, newId, result.tetrahedra, result);
    else
        takeSuspects(file.triangles, inspection.suspects, newId, result.triangles, result);
    for (const FaultKind& kind : inspection.faults)
        result.fields.push_back(tagsOf(kind, inspection.suspects));
    MeshField numbers{"vertex", false, 1, {}};
    for (std::size_t v = 0; v < newId.size(); ++v) {
        if (newId[v] < 0) continue;
        newId[v] = static_cast<int>(numbers.values.size());
        numbers.values.push_back(static_cast<double>(v));
    }
    result.points.resize(3, static_cast<Eigen::Index>(numbers.values.size()));
    for (std::size_t i = 0; i < numbers.values.size(); ++i)
        result.points.col(static_cast<Eigen::Index>(i)) =
            file.points.col(static_cast<int>(numbers.values[i]));
    for (auto& cell : result.triangles)
        for (int& v : cell) v = newId[v];
    for (auto& cell : result.tetrahedra)
        for (int& v : cell) v = newId[v];
    result.fields.push_back(std::move(numbers));
    writeMeshFile(path, result);
}

}  // namespace wend
