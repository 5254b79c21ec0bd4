#pragma once

#include <cstddef>
#include <optional>

namespace wend {

/// The kinds of cell that mesh files hold. Nodes are in VTK's order: corners first, then those in the middle
/// of edges, faces and the cell.
enum class CellKind : unsigned char {
    Vertex,
    PolyVertex,
    Line,
    PolyLine,
    Line3,
    Triangle,
    Quad,
    Polygon,
    TriangleStrip,
    Triangle6,
    Quad8,
    Quad9,
    Tetrahedron,
    Pyramid,
    Wedge,
    Hexahedron,
    Tetrahedron10,
    Pyramid13,
    Wedge15,
    Wedge18,
    Hexahedron20,
    Hexahedron27
};
constexpr std::size_t kCellKinds = 22;

/// The properties of a kind of cell.
struct CellKindFacts {
    const char *name, *plural;
    int dimension;
    int corners, nodes;  // 0: any number
    int vtk;             // its number in VTK
};
/// Returns the properties of a kind.
const CellKindFacts& factsOf(CellKind kind);

/// Returns the kind with this number in VTK; nothing if there is none.
std::optional<CellKind> cellKindOfVtk(long number);
/// Returns the kind of the same shape without nodes between the corners.
CellKind linearKind(CellKind kind);

}  // namespace wend
