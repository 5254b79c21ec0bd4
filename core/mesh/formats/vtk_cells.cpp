#include "core/mesh/formats/vtk_cells.h"

#include "core/base/error.h"

namespace wend::formats {
namespace {

constexpr int kPixel = 8, kVoxel = 11;
constexpr std::pair<int, const char*> unreadTypes[] = {
    {34, "triangle of second order with a node in its middle"}, {41, "convex point set"}, {42, "polyhedron"}};

[[noreturn]] void failAt(std::size_t cell, const std::string& what) {
    throw InputError("cell " + std::to_string(cell) + ": " + what);
}

std::string typeInWords(std::int64_t type) {
    for (const auto& [number, name] : unreadTypes)
        if (number == type) return std::string("a ") + name;
    return "VTK's cell type " + std::to_string(type);
}

void requireCorners(std::size_t cell, std::size_t count, std::size_t needed) {
    if (count != needed)
        failAt(cell,
               "has " + std::to_string(count) + " corners where " + std::to_string(needed) + " are needed");
}

/// Turns the triangles of a linear wedge, which VTK numbers in the opposite direction to Gmsh, Abaqus and
/// Nastran, whose order the list has.
void turnWedge(auto nodes) {
    std::swap(nodes[1], nodes[2]);
    std::swap(nodes[4], nodes[5]);
}

void addCell(std::int64_t type, std::vector<int>& corners, std::size_t cell, CellList& list) {
    if (type == kPixel || type == kVoxel) {
        requireCorners(cell, corners.size(), type == kPixel ? 4 : 8);
        for (std::size_t k = 2; k < corners.size(); k += 4) std::swap(corners[k], corners[k + 1]);
        return list.add(type == kPixel ? CellKind::Quad : CellKind::Hexahedron, corners);
    }
    const auto kind = cellKindOfVtk(type);
    if (!kind) failAt(cell, typeInWords(type) + " is not read");
    if (const int nodes = factsOf(*kind).nodes; nodes > 0)
        requireCorners(cell, corners.size(), static_cast<std::size_t>(nodes));
    if (*kind == CellKind::Wedge) turnWedge(std::span(corners));
    list.add(*kind, corners);
}

}  // namespace

/// Checks each cell's type, its number of nodes and its range of vertices before it is added.
void collect(const VtkCells& cells, long vertexCount, int firstVertex, CellList& list) {
    if (cells.offsets.size() != cells.types.size() + 1)
        throw InputError("there are " + std::to_string(cells.types.size()) + " cell types and " +
                         std::to_string(cells.offsets.size()) + " offsets");
    std::vector<int> corners;
    for (std::size_t c = 0; c < cells.types.size(); ++c) {
        const auto begin = cells.offsets[c], end = cells.offsets[c + 1];
        if (begin < 0 || end < begin || end > static_cast<std::int64_t>(cells.connectivity.size()))
            failAt(c, "its offset is outside the connectivity");
        corners.clear();
        for (auto at = begin; at < end; ++at) {
            const auto v = cells.connectivity[static_cast<std::size_t>(at)];
            if (v < 0 || v >= vertexCount)
                failAt(c, "names vertex " + std::to_string(v) + ", but there are only " +
                              std::to_string(vertexCount) + " (counted from 0)");
            corners.push_back(firstVertex + static_cast<int>(v));
        }
        addCell(cells.types[c], corners, c, list);
    }
}

int polySectionOf(CellKind kind) {
    constexpr int kStrips = 2, kPolygons = 3;
    const int dimension = factsOf(kind).dimension;
    return dimension < 2 ? dimension : kind == CellKind::TriangleStrip ? kStrips : kPolygons;
}

VtkCells vtkCellsOf(const CellList& list) {
    VtkCells cells;
    cells.offsets.assign(list.begins.begin(), list.begins.end());
    cells.connectivity.assign(list.nodes.begin(), list.nodes.end());
    for (int c = 0; c < list.size(); ++c) {
        const CellKind kind = list.kinds[static_cast<std::size_t>(c)];
        cells.types.push_back(factsOf(kind).vtk);
        if (kind == CellKind::Wedge)
            turnWedge(std::span(cells.connectivity).subspan(static_cast<std::size_t>(list.begins[c]), 6));
    }
    return cells;
}

}  // namespace wend::formats
