#pragma once

#include <functional>
#include <vector>

#include "core/meshing/outline.h"

namespace wend {

/// The sampling of a picture for contours. Node columns 2 … width + 1 are at the pixels' centres; columns 1
/// and width + 2 are on the picture's border and repeat the nearest pixel; columns 0 and width + 3 are on the
/// same border and always outside, so that contours close along the border, including corners. Rows likewise.
struct ContourGrid {
    int width = 0, height = 0;

    int columns() const { return width + 4; }
    int rows() const { return height + 4; }
    double x(int column) const { return coordinate(column, width); }
    double y(int row) const { return coordinate(row, height); }
    /// Returns the pixel whose value a node has.
    static int pixel(int node, int size) { return node <= 2 ? 0 : node >= size + 1 ? size - 1 : node - 2; }

  private:
    static double coordinate(int node, int size) {
        return node <= 1 ? 0 : node >= size + 2 ? size : node - 1.5;
    }
};

/// Fills the values of a row of nodes; positive is inside. Rows are asked for in ascending order, each once.
using RowSource = std::function<void(int row, std::vector<float>& values)>;

/// Returns the closed zero contours by marching squares, without repeated points: linear along grid edges,
/// ambiguous cells decided by their mean. Loops do not cross. Memory grows with the contours only. Throws
/// InputError if there are too many.
std::vector<std::vector<Vec2>> zeroContours(const ContourGrid& grid, const RowSource& source);

}  // namespace wend
