#include "core/mesh/cell_kind.h"

#include <array>

namespace wend {
namespace {

constexpr std::array<CellKindFacts, kCellKinds> kFacts{{
    {"vertex", "vertices", 0, 1, 1, 1},
    {"vertex cell", "vertex cells", 0, 0, 0, 2},
    {"line", "lines", 1, 2, 2, 3},
    {"polyline", "polylines", 1, 0, 0, 4},
    {"second-order line", "second-order lines", 1, 2, 3, 21},
    {"triangle", "triangles", 2, 3, 3, 5},
    {"quadrilateral", "quadrilaterals", 2, 4, 4, 9},
    {"polygon", "polygons", 2, 0, 0, 7},
    {"triangle strip", "triangle strips", 2, 0, 0, 6},
    {"second-order triangle", "second-order triangles", 2, 3, 6, 22},
    {"second-order quadrilateral", "second-order quadrilaterals", 2, 4, 8, 23},
    {"second-order quadrilateral", "second-order quadrilaterals", 2, 4, 9, 28},
    {"tetrahedron", "tetrahedra", 3, 4, 4, 10},
    {"pyramid", "pyramids", 3, 5, 5, 14},
    {"wedge", "wedges", 3, 6, 6, 13},
    {"hexahedron", "hexahedra", 3, 8, 8, 12},
    {"second-order tetrahedron", "second-order tetrahedra", 3, 4, 10, 24},
    {"second-order pyramid", "second-order pyramids", 3, 5, 13, 27},
    {"second-order wedge", "second-order wedges", 3, 6, 15, 26},
    {"second-order wedge", "second-order wedges", 3, 6, 18, 32},
    {"second-order hexahedron", "second-order hexahedra", 3, 8, 20, 25},
    {"second-order hexahedron", "second-order hexahedra", 3, 8, 27, 29},
}};

}  // namespace

const CellKindFacts& factsOf(CellKind kind) {
    return kFacts[static_cast<std::size_t>(kind)];
}

std::optional<CellKind> cellKindOfVtk(long number) {
    for (std::size_t k = 0; k < kFacts.size(); ++k)
        if (kFacts[k].vtk == number) return static_cast<CellKind>(k);
    return std::nullopt;
}

CellKind linearKind(CellKind kind) {
    switch (kind) {
        case CellKind::Line3:
            return CellKind::Line;
        case CellKind::Triangle6:
            return CellKind::Triangle;
        case CellKind::Quad8:
        case CellKind::Quad9:
            return CellKind::Quad;
        case CellKind::Tetrahedron10:
            return CellKind::Tetrahedron;
        case CellKind::Pyramid13:
            return CellKind::Pyramid;
        case CellKind::Wedge15:
        case CellKind::Wedge18:
            return CellKind::Wedge;
        case CellKind::Hexahedron20:
        case CellKind::Hexahedron27:
            return CellKind::Hexahedron;
        default:
            return kind;
    }
}

}  // namespace wend
