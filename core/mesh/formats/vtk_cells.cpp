#include "core/mesh/formats/vtk_cells.h"

#include "core/mesh/error.h"

namespace wend::formats {
namespace {

enum VtkType {
    Vertex = 1,
    PolyVertex,
    Line,
    PolyLine,
    Triangle,
    TriangleStrip,
    PolygonCell,
    Pixel,
    Quad,
    Tetrahedron
};

constexpr std::pair<int, const char*> unreadTypes[] = {{11, "voxel"},
                                                       {12, "hexahedron"},
                                                       {13, "wedge"},
                                                       {14, "pyramid"},
                                                       {22, "triangle of second order"},
                                                       {24, "tetrahedron of second order"},
                                                       {42, "polyhedron"}};

[[noreturn]] void failAt(std::size_t cell, const std::string& what) {
    throw InputError("cell " + std::to_string(cell) + ": " + what);
}

std::string nameOf(std::int64_t type) {
    for (const auto& [number, name] : unreadTypes)
        if (number == type) return std::string("a ") + name;
    return "VTK's cell type " + std::to_string(type);
}

void requireCorners(std::size_t cell, std::size_t count, std::size_t needed) {
    if (count != needed)
        failAt(cell,
               "has " + std::to_string(count) + " corners where " + std::to_string(needed) + " are needed");
}

void addStrip(std::span<const int> corners, int element, CellCollector& collector) {
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const bool odd = k % 2 != 0;
        const int turned[] = {corners[k - (odd ? 1 : 2)], corners[k - (odd ? 2 : 1)], corners[k]};
        collector.polygon(turned, element);
    }
}

void add(std::int64_t type, std::span<const int> corners, std::size_t cell, int element,
         CellCollector& collector) {
    switch (type) {
        case Vertex:
        case PolyVertex:
        case Line:
        case PolyLine:
            return;
        case Triangle:
            requireCorners(cell, corners.size(), 3);
            return collector.polygon(corners, element);
        case TriangleStrip:
            return addStrip(corners, element, collector);
        case Quad:
            requireCorners(cell, corners.size(), 4);
            return collector.polygon(corners, element);
        case PolygonCell:
            return collector.polygon(corners, element);
        case Pixel: {
            requireCorners(cell, corners.size(), 4);
            const int around[] = {corners[0], corners[1], corners[3], corners[2]};
            return collector.polygon(around, element);
        }
        case Tetrahedron:
            requireCorners(cell, corners.size(), 4);
            return collector.tetrahedron({corners[0], corners[1], corners[2], corners[3]}, element);
        default:
            failAt(cell, nameOf(type) + ": only triangles and tetrahedra are read");
    }
}

}  // namespace

void collect(const VtkCells& cells, Eigen::Index vertexCount, int first, CellCollector& collector) {
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
            const auto v = cells.connectivity[at];
            if (v < 0 || v >= vertexCount)
                failAt(c, "names vertex " + std::to_string(v) + ", but there are only " +
                              std::to_string(vertexCount) + " (counted from 0)");
            corners.push_back(static_cast<int>(v));
        }
        add(cells.types[c], corners, c, first + static_cast<int>(c), collector);
    }
}

}  // namespace wend::formats
