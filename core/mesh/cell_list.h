#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mesh/cell_kind.h"

namespace wend {

/// Cells of any kinds in the order of their file. Cell c has the nodes nodes[begins[c] … begins[c + 1] − 1].
struct CellList {
    std::vector<CellKind> kinds;
    std::vector<int> begins{0}, nodes;

    int size() const { return static_cast<int>(kinds.size()); }
    bool empty() const { return kinds.empty(); }
    /// Returns the nodes of a cell.
    std::span<const int> operator[](int c) const {
        return std::span(nodes).subspan(static_cast<std::size_t>(begins[c]),
                                        static_cast<std::size_t>(begins[c + 1] - begins[c]));
    }
    int dimension(int c) const { return factsOf(kinds[static_cast<std::size_t>(c)]).dimension; }
    /// Appends a cell.
    void add(CellKind kind, std::span<const int> cell) {
        kinds.push_back(kind);
        nodes.insert(nodes.end(), cell.begin(), cell.end());
        begins.push_back(static_cast<int>(nodes.size()));
    }
    /// Appends a triangle, a quadrilateral or a polygon.
    void addFace(std::span<const int> corners) {
        add(corners.size() == 3   ? CellKind::Triangle
            : corners.size() == 4 ? CellKind::Quad
                                  : CellKind::Polygon,
            corners);
    }
};

/// Cells, or vertices, that a file calls by one name or number. Groups may overlap.
struct MeshGroup {
    std::string name;           // empty: it has a number only
    int dimension = 2;          // of its cells; 0 for vertices
    long tag = 0;               // its number in the file; 0: it has a name only
    std::vector<int> cells;     // of the file's, ascending
    std::vector<int> vertices;  // of a group of vertices
    bool material = false;      // it says what the cells are made of or look like (OBJ's usemtl)
};

}  // namespace wend
