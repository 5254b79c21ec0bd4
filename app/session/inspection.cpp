#include "app/session/inspection.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/mesh/simplicial_mesh.h"
#include "core/mesh/used_vertices.h"
#include "core/meshing/surface.h"

namespace wend {
namespace {

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

/// Cells per facet, as sorted vertices.
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

int root(std::vector<int>& parents, int at) {
    while (parents[at] != at) at = parents[at] = parents[parents[at]];
    return at;
}

/// Parts that hang together by facets.
template <int Dim>
int countParts(const std::map<Key<Dim>, std::vector<int>>& facets, int cells) {
    std::vector<int> parents(cells);
    std::iota(parents.begin(), parents.end(), 0);
    for (const auto& [facet, around] : facets)
        for (int cell : around) parents[root(parents, cell)] = root(parents, around.front());
    int parts = 0;
    for (int c = 0; c < cells; ++c) parts += root(parents, c) == c;
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

/// Cells that are oriented against the greater number.
template <int Dim>
std::vector<int> invertedCells(const SimplicialMesh<Dim>& mesh) {
    std::vector<int> positive, negative;
    for (int c = 0; c < mesh.cellCount(); ++c) {
        if (isFlat<Dim>(mesh.points, mesh.cells[c])) continue;
        (cellMeasure<Dim>(mesh.points, mesh.cells[c]) > 0 ? positive : negative).push_back(c);
    }
    return positive.size() < negative.size() ? positive : negative;
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
    add("cells oriented against the others", invertedCells<Dim>(mesh));
    add(Dim == 2 ? "cells at edges of more than two" : "cells at faces of more than two",
        crowdedCells<Dim>(facets));
    add("vertices that no cell uses", unusedVertices<Dim>(mesh), false);
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
}

bool isPlanar(const MeshFile& file) {
    const double spread = file.points.row(2).maxCoeff() - file.points.row(2).minCoeff();
    return spread <= 1e-12 * boundingBoxDiagonal<3>(file.points);
}

void inspectSurface(const MeshFile& file, MeshInspection& inspection) {
    inspection.diagonal = boundingBoxDiagonal<3>(file.points);
    const auto edges = cellsOfFacets<2>(file.triangles);
    inspection.parts = countParts<2>(edges, static_cast<int>(file.triangles.size()));
    inspection.surface = checkSurface(Surface{file.points, file.triangles, {}}).summary();
}

}  // namespace

MeshInspection inspect(const MeshFile& file) {
    MeshInspection inspection;
    inspection.vertices = static_cast<int>(file.points.cols());
    inspection.triangles = static_cast<int>(file.triangles.size());
    if (isVolume(file))
        inspectPartition<3>({file.points, file.tetrahedra}, inspection);
    else if (isPlanar(file))
        inspectPartition<2>({file.points.topRows<2>(), file.triangles}, inspection);
    else
        inspectSurface(file, inspection);
    return inspection;
}

}  // namespace wend
