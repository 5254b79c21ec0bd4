#include "core/mesh/file_cells.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/mesh/mesh_file.h"

namespace wend {
namespace {

/// The three neighbours of each corner by edges, so that positive cells have positive corners.
using Corners = std::vector<std::array<int, 4>>;

/// Returns for every corner of a cell the corner itself and the ends of the three edges that leave it.
const Corners& cornersOf(CellKind linear) {
    static const Corners tetrahedron{{0, 1, 2, 3}},
        pyramid{{0, 1, 3, 4}, {1, 2, 0, 4}, {2, 3, 1, 4}, {3, 0, 2, 4}},
        wedge{{0, 1, 2, 3}, {1, 2, 0, 4}, {2, 0, 1, 5}, {3, 5, 4, 0}, {4, 3, 5, 1}, {5, 4, 3, 2}},
        hexahedron{{0, 1, 3, 4}, {1, 2, 0, 5}, {2, 3, 1, 6}, {3, 0, 2, 7},
                   {4, 7, 5, 0}, {5, 4, 6, 1}, {6, 5, 7, 2}, {7, 6, 4, 3}},
        none;
    switch (linear) {
        case CellKind::Tetrahedron:
            return tetrahedron;
        case CellKind::Pyramid:
            return pyramid;
        case CellKind::Wedge:
            return wedge;
        case CellKind::Hexahedron:
            return hexahedron;
        default:
            return none;
    }
}

double cornerJacobian(const Points3& points, std::span<const int> nodes, const std::array<int, 4>& corner) {
    const auto at = [&](int k) -> Vec3 { return points.col(nodes[static_cast<std::size_t>(k)]); };
    const Vec3 a = at(corner[1]) - at(corner[0]), b = at(corner[2]) - at(corner[0]),
               c = at(corner[3]) - at(corner[0]);
    const double lengths = a.norm() * b.norm() * c.norm();
    return lengths > 0 ? a.cross(b).dot(c) / lengths : 0;
}

/// Returns the corner Jacobian of a quadrilateral in the plane of x and y.
double flatJacobian(const Points3& points, std::span<const int> nodes, int k) {
    const auto at = [&](int i) -> Vec2 {
        return points.col(nodes[static_cast<std::size_t>((k + i) % 4)]).head<2>();
    };
    const Vec2 a = at(1) - at(0), b = at(3) - at(0);
    const double lengths = a.norm() * b.norm();
    return lengths > 0 ? (a.x() * b.y() - a.y() * b.x()) / lengths : 0;
}

/// Returns the least corner Jacobian of a cell times `sign`, its orientation in the file.
double leastJacobian(const MeshFile& file, const Points3& points, int cell, double sign) {
    const CellKind linear = linearKind(file.cells.kinds[static_cast<std::size_t>(cell)]);
    const auto nodes = file.cells[cell];
    double least = 1;
    if (!isVolume(file) && linear == CellKind::Quad)
        for (int k = 0; k < 4; ++k) least = std::min(least, sign * flatJacobian(points, nodes, k));
    for (const auto& corner : cornersOf(linear))
        least = std::min(least, sign * cornerJacobian(points, nodes, corner));
    return least;
}

/// Returns −1 for cells that are numbered in the opposite orientation, else 1.
double orientationOf(const MeshFile& file, int cell) {
    return leastJacobian(file, file.points, cell, 1) < 0 && leastJacobian(file, file.points, cell, -1) > 0
               ? -1
               : 1;
}

bool isOfMesh(const MeshFile& file, int cell) {
    return file.cells.dimension(cell) == (isVolume(file) ? 3 : 2);
}

}  // namespace

/// Marks the vertices of triangles and tetrahedra, and returns those that only other cells name.
std::vector<int> carriedNodes(const MeshFile& file) {
    std::vector<char> own(static_cast<std::size_t>(file.points.cols()), 0), named = own;
    for (const int v : file.cells.nodes) named[static_cast<std::size_t>(v)] = 1;
    if (isVolume(file))
        for (const auto& cell : file.tetrahedra)
            for (const int v : cell) own[static_cast<std::size_t>(v)] = 1;
    else
        for (const auto& cell : file.triangles)
            for (const int v : cell) own[static_cast<std::size_t>(v)] = 1;
    std::vector<int> carried;
    for (std::size_t v = 0; v < own.size(); ++v)
        if (named[v] && !own[v]) carried.push_back(static_cast<int>(v));
    return carried;
}

bool hasWholeCells(const MeshFile& file) {
    for (int c = 0; c < file.cells.size(); ++c)
        if (const CellKind kind = file.cells.kinds[static_cast<std::size_t>(c)];
            isOfMesh(file, c) && kind != CellKind::Triangle && kind != CellKind::Tetrahedron)
            return true;
    return false;
}

std::vector<std::pair<std::string, int>> cellCounts(const MeshFile& file) {
    std::array<int, kCellKinds> counts{};
    for (const CellKind kind : file.cells.kinds) ++counts[static_cast<std::size_t>(kind)];
    std::vector<std::pair<std::string, int>> all;
    for (std::size_t k = 0; k < counts.size(); ++k)
        if (counts[k] > 0) all.emplace_back(factsOf(static_cast<CellKind>(k)).plural, counts[k]);
    const bool plain = all.size() == 1 && !hasWholeCells(file);
    return plain ? std::vector<std::pair<std::string, int>>() : all;
}

std::vector<double> cornerJacobians(const MeshFile& file, const Points3& points) {
    std::vector<double> jacobians;
    for (int c = 0; c < file.cells.size(); ++c)
        if (isOfMesh(file, c)) jacobians.push_back(leastJacobian(file, points, c, orientationOf(file, c)));
    return jacobians;
}

/// Counts the cells whose corner Jacobian is no longer positive.
std::string turnedCells(const MeshFile& file, const Points3& points) {
    const std::vector<double> before = cornerJacobians(file, file.points),
                              after = cornerJacobians(file, points);
    int count = 0, first = -1;
    for (std::size_t c = 0; c < before.size(); ++c) {
        if (!(before[c] > 0 && after[c] <= 0)) continue;
        if (++count == 1) first = static_cast<int>(c);
    }
    if (count == 0) return {};
    return std::to_string(count) + " of " + std::to_string(before.size()) +
           (count == 1 ? " cells is" : " cells are") + " turned over at a corner, the first cell " +
           std::to_string(first);
}

}  // namespace wend
