#include "core/mesh/formats/gmsh_elements.h"

#include <algorithm>

namespace wend::formats {
namespace {

/// The orders of nodes are those of Gmsh's manual, "Node ordering", and of VTK's file formats.
const std::vector<GmshElement>& elements() {
    static const std::vector<GmshElement> all = {
        {15, CellKind::Vertex, {}},
        {1, CellKind::Line, {}},
        {8, CellKind::Line3, {}},
        {2, CellKind::Triangle, {}},
        {9, CellKind::Triangle6, {}},
        {3, CellKind::Quad, {}},
        {16, CellKind::Quad8, {}},
        {10, CellKind::Quad9, {}},
        {4, CellKind::Tetrahedron, {}},
        {11, CellKind::Tetrahedron10, {0, 1, 2, 3, 4, 5, 6, 7, 9, 8}},
        {7, CellKind::Pyramid, {}},
        {19, CellKind::Pyramid13, {0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12}},
        {6, CellKind::Wedge, {}},
        {18, CellKind::Wedge15, {0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11}},
        {13, CellKind::Wedge18, {0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11, 15, 17, 16}},
        {5, CellKind::Hexahedron, {}},
        {17, CellKind::Hexahedron20, {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15}},
        {12, CellKind::Hexahedron27, {0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  16, 18,
                                      19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26}},
    };
    return all;
}

}  // namespace

const GmshElement* gmshElement(int number) {
    const auto found = std::ranges::find(elements(), number, &GmshElement::number);
    return found == elements().end() ? nullptr : &*found;
}

const GmshElement* gmshElement(CellKind kind) {
    const auto found = std::ranges::find(elements(), kind, &GmshElement::kind);
    return found == elements().end() ? nullptr : &*found;
}

std::string unreadGmshElement(int number) {
    constexpr std::pair<int, const char*> names[] = {
        {14, "a pyramid of second order with a node in its base"},
        {21, "a triangle of third order"},
        {26, "a line of third order"},
        {29, "a tetrahedron of third order"},
        {36, "a quadrilateral of third order"},
        {92, "a hexahedron of third order"}};
    for (const auto& [known, name] : names)
        if (known == number) return name;
    return "element type " + std::to_string(number);
}

}  // namespace wend::formats
