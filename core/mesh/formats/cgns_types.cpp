#include <algorithm>
#include <array>

#include "core/mesh/formats/cgns.h"

namespace wend::formats {

std::span<const CgnsType> cgnsTypes() {
    static const std::array<CgnsType, 18> types{{
        {2, CellKind::Vertex, {}},
        {3, CellKind::Line, {}},
        {4, CellKind::Line3, {}},
        {5, CellKind::Triangle, {}},
        {6, CellKind::Triangle6, {}},
        {7, CellKind::Quad, {}},
        {8, CellKind::Quad8, {}},
        {9, CellKind::Quad9, {}},
        {10, CellKind::Tetrahedron, {}},
        {11, CellKind::Tetrahedron10, {}},
        {12, CellKind::Pyramid, {}},
        {21, CellKind::Pyramid13, {}},
        {14, CellKind::Wedge, {}},
        {15, CellKind::Wedge15, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11}},
        {16, CellKind::Wedge18, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11, 15, 16, 17}},
        {17, CellKind::Hexahedron, {}},
        {18, CellKind::Hexahedron20, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15}},
        {19, CellKind::Hexahedron27, {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 16, 17,
                                      18, 19, 12, 13, 14, 15, 24, 22, 21, 23, 20, 25, 26}},
    }};
    return types;
}

const CgnsType& cgnsTypeOf(CellKind kind) {
    return *std::ranges::find(cgnsTypes(), kind, &CgnsType::kind);
}

}  // namespace wend::formats
