#include <array>

#include "core/mesh/formats/med.h"

namespace wend::formats {

std::span<const MedType> medTypes() {
    static const std::array<MedType, 18> types{{
        {"PO1", 1, CellKind::Vertex, {}},
        {"SE2", 102, CellKind::Line, {}},
        {"SE3", 103, CellKind::Line3, {}},
        {"TR3", 203, CellKind::Triangle, {}},
        {"TR6", 206, CellKind::Triangle6, {}},
        {"QU4", 204, CellKind::Quad, {}},
        {"QU8", 208, CellKind::Quad8, {}},
        {"QU9", 209, CellKind::Quad9, {}},
        {"TE4", 304, CellKind::Tetrahedron, {0, 2, 1, 3}},
        {"T10", 310, CellKind::Tetrahedron10, {0, 2, 1, 3, 6, 5, 4, 7, 9, 8}},
        {"PY5", 305, CellKind::Pyramid, {0, 3, 2, 1, 4}},
        {"P13", 313, CellKind::Pyramid13, {0, 3, 2, 1, 4, 8, 7, 6, 5, 9, 12, 11, 10}},
        {"PE6", 306, CellKind::Wedge, {0, 2, 1, 3, 5, 4}},
        {"P15", 315, CellKind::Wedge15, {0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13}},
        {"P18", 318, CellKind::Wedge18, {0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13, 17, 16, 15}},
        {"HE8", 308, CellKind::Hexahedron, {0, 3, 2, 1, 4, 7, 6, 5}},
        {"H20", 320, CellKind::Hexahedron20, {0, 3, 2,  1,  4,  7,  6,  5,  11, 10,
                                              9, 8, 15, 14, 13, 12, 16, 19, 18, 17}},
        {"H27", 327, CellKind::Hexahedron27, {0,  3,  2,  1,  4,  7,  6,  5,  11, 10, 9,  8,  15, 14,
                                              13, 12, 16, 19, 18, 17, 21, 23, 24, 22, 20, 25, 26}},
    }};
    return types;
}

}  // namespace wend::formats
