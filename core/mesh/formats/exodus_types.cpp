#include <algorithm>
#include <array>

#include "core/mesh/formats/exodus.h"
#include "core/mesh/formats/scanner.h"

namespace wend::formats {
namespace {

std::span<const ExodusType> types() {
    static const std::array<ExodusType, 18> all{{
        {"SPHERE", CellKind::Vertex, {}},
        {"BAR2", CellKind::Line, {}},
        {"BAR3", CellKind::Line3, {}},
        {"TRI3", CellKind::Triangle, {}},
        {"TRI6", CellKind::Triangle6, {}},
        {"QUAD4", CellKind::Quad, {}},
        {"QUAD8", CellKind::Quad8, {}},
        {"QUAD9", CellKind::Quad9, {}},
        {"TETRA", CellKind::Tetrahedron, {}},
        {"TETRA10", CellKind::Tetrahedron10, {}},
        {"PYRAMID", CellKind::Pyramid, {}},
        {"PYRAMID13", CellKind::Pyramid13, {}},
        {"WEDGE", CellKind::Wedge, {}},
        {"WEDGE15", CellKind::Wedge15, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11}},
        {"WEDGE18", CellKind::Wedge18, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11, 15, 16, 17}},
        {"HEX8", CellKind::Hexahedron, {}},
        {"HEX20", CellKind::Hexahedron20, {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,
                                           10, 11, 16, 17, 18, 19, 12, 13, 14, 15}},
        {"HEX27", CellKind::Hexahedron27, {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 16, 17,
                                           18, 19, 12, 13, 14, 15, 23, 24, 25, 26, 21, 22, 20}},
    }};
    return all;
}

/// Other names that are in use, by their beginnings.
constexpr std::pair<std::string_view, std::string_view> kOther[] = {
    {"SHEL", "QUAD"}, {"TRIS", "TRI"},   {"TRUS", "BAR"},   {"BEAM", "BAR"},
    {"EDGE", "BAR"},  {"ROD", "BAR"},    {"TET", "TETRA"},  {"PYR", "PYRAMID"},
    {"WED", "WEDGE"}, {"HEX", "HEX"},    {"QUA", "QUAD"},   {"TRI", "TRI"},
    {"BAR", "BAR"},   {"SPH", "SPHERE"}, {"CIR", "SPHERE"}, {"POINT", "SPHERE"}};

}  // namespace

const ExodusType* exodusTypeOf(CellKind kind) {
    const auto found = std::ranges::find(types(), kind, &ExodusType::kind);
    return found == types().end() ? nullptr : &*found;
}

const ExodusType* exodusTypeNamed(std::string_view name, std::size_t nodes) {
    for (const auto& [beginning, usual] : kOther) {
        if (!sameWord(name.substr(0, beginning.size()), beginning)) continue;
        // A shell of three nodes is a triangle.
        const std::string_view family = usual == "QUAD" && (nodes == 3 || nodes == 6) ? "TRI" : usual;
        for (const ExodusType& type : types())
            if (type.name.starts_with(family) && factsOf(type.kind).nodes == static_cast<int>(nodes))
                return &type;
        return nullptr;
    }
    return nullptr;
}

std::vector<std::vector<int>> exodusSidesOf(CellKind kind) {
    switch (linearKind(kind)) {
        case CellKind::Triangle:
            return {{0, 1}, {1, 2}, {2, 0}};
        case CellKind::Quad:
            return {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
        case CellKind::Tetrahedron:
            return {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}};
        case CellKind::Pyramid:
            return {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}, {0, 3, 2, 1}};
        case CellKind::Wedge:
            return {{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1}, {3, 4, 5}};
        case CellKind::Hexahedron:
            return {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
        default:
            return {};
    }
}

}  // namespace wend::formats
