#include "core/mesh/cell_shape.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace wend {
namespace {

/// Returns the edges from the first corner as columns.
template <int Dim>
Mat<Dim> edgeMatrix(const Points<Dim>& points, const Cell<Dim>& cell) {
    Mat<Dim> edges;
    for (int k = 0; k < Dim; ++k) edges.col(k) = points.col(cell[k + 1]) - points.col(cell[0]);
    return edges;
}

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}
double angleBetween(const Vec2& a, const Vec2& b) {
    return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}

/// Computes the angles at the corners of a triangle.
void measureAngles(const std::array<Vec2, 3>& p, CellShape& shape) {
    for (int k = 0; k < 3; ++k) {
        const double angle = angleBetween(Vec2(p[(k + 1) % 3] - p[k]), Vec2(p[(k + 2) % 3] - p[k]));
        shape.minAngle = std::min(shape.minAngle, angle);
        shape.maxAngle = std::max(shape.maxAngle, angle);
    }
}

/// The angle at an edge is that between the parts of two other edges across it.
void measureAngles(const std::array<Vec3, 4>& p, CellShape& shape) {
    for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j) {
            const int k = i == 0 ? (j == 1 ? 2 : 1) : 0, l = 6 - i - j - k;
            const Vec3 edge = p[j] - p[i];
            const double angle = angleBetween(Vec3(edge.cross(p[k] - p[i])), Vec3(edge.cross(p[l] - p[i])));
            shape.minAngle = std::min(shape.minAngle, angle);
            shape.maxAngle = std::max(shape.maxAngle, angle);
        }
}

double surfaceOf(const std::array<Vec2, 3>& p) {
    return (p[1] - p[0]).norm() + (p[2] - p[1]).norm() + (p[0] - p[2]).norm();
}
double surfaceOf(const std::array<Vec3, 4>& p) {
    double area = 0;
    for (int k = 0; k < 4; ++k)
        area += 0.5 * (p[(k + 2) % 4] - p[(k + 1) % 4]).cross(p[(k + 3) % 4] - p[(k + 1) % 4]).norm();
    return area;
}

}  // namespace

/// Computes the edges at every corner first: their products bound the Jacobian, and the longest one gives the
/// aspect ratio.
template <int Dim>
CellShape cellShape(const Points<Dim>& points, const Cell<Dim>& cell) {
    std::array<Vec<Dim>, Dim + 1> p;
    for (int k = 0; k <= Dim; ++k) p[k] = points.col(cell[k]);
    double longest = 0, product = 0;
    for (int i = 0; i <= Dim; ++i) {
        double at = 1, largest = 0;
        std::array<double, Dim> lengths;
        for (int j = 0, n = 0; j <= Dim; ++j)
            if (j != i) lengths[n++] = (p[j] - p[i]).norm();
        for (const double length : lengths) at *= length, largest = std::max(largest, length);
        longest = std::max(longest, largest);
        product = std::max(product, at);
    }
    CellShape shape;
    const double J = edgeMatrix<Dim>(points, cell).determinant(),
                 scale = Dim == 2 ? 2 / std::sqrt(3.0) : std::sqrt(2.0);
    const double measure = std::abs(J) / (Dim == 2 ? 2 : 6);
    shape.scaledJacobian = product > 0 ? scale * J / std::max(product, std::abs(J)) : 0;
    const double radius = Dim * measure / surfaceOf(p);  // of the inscribed ball
    const double best = Dim == 2 ? 2 * std::sqrt(3.0) : 2 * std::sqrt(6.0);
    shape.aspectRatio = radius > 0 ? longest / (best * radius) : std::numeric_limits<double>::infinity();
    shape.minAngle = std::numeric_limits<double>::infinity();
    measureAngles(p, shape);
    return shape;
}

template <int Dim>
std::vector<CellShape> cellShapes(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells) {
    std::vector<CellShape> all;
    all.reserve(cells.size());
    for (const Cell<Dim>& cell : cells) all.push_back(cellShape<Dim>(points, cell));
    return all;
}

template <int Dim>
std::vector<Mat<Dim>> deformationGradients(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    std::vector<Mat<Dim>> all;
    all.reserve(rest.cells.size());
    for (const Cell<Dim>& cell : rest.cells)
        all.push_back(edgeMatrix<Dim>(pose, cell) * edgeMatrix<Dim>(rest.points, cell).inverse());
    return all;
}

#define WEND_INSTANTIATE(Dim)                                                                           \
    template CellShape cellShape<Dim>(const Points<Dim>&, const Cell<Dim>&);                            \
    template std::vector<CellShape> cellShapes<Dim>(const Points<Dim>&, const std::vector<Cell<Dim>>&); \
    template std::vector<Mat<Dim>> deformationGradients<Dim>(const SimplicialMesh<Dim>&, const Points<Dim>&);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)
#undef WEND_INSTANTIATE

}  // namespace wend
