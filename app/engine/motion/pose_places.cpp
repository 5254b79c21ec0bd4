#include "app/engine/motion/pose_places.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "app/engine/shape/shape.h"
#include "core/energy/cell_energy.h"
#include "core/mesh/decompositions.h"

namespace wend {

namespace {

constexpr double kFlatPoints = 1e-6;  // fraction of the extent below which points count as coplanar

SolidSize sizeWhere(const PosedFrame<3>& frame, const Points<3>& points, const std::vector<bool>& in) {
    const auto all = [&in](const auto& vertices) {
        return std::all_of(vertices.begin(), vertices.end(), [&in](int v) { return in[v]; });
    };
    SolidSize size;
    for (const Cell<3>& cell : frame.rest->cells)
        if (all(cell)) size.volume += std::abs(cellMeasure<3>(points, cell));
    for (const Facet<3>& facet : *frame.built->facets) {
        if (facet.interior() || !all(facet.vertices)) continue;
        const Vec<3> a = points.col(facet.vertices[0]);
        const Vec<3> u = points.col(facet.vertices[1]) - a, v = points.col(facet.vertices[2]) - a;
        size.area += u.cross(v).norm() / 2;
    }
    return size;
}

}  // namespace

template <int Dim>
Location<Dim> locationIn(const PosedFrame<Dim>& frame, int cell, const Vec<Dim>& p) {
    Location<Dim> location;
    location.cell = cell;
    const Cell<Dim>& corners = frame.rest->cells[cell];
    const Vec<Dim> w =
        edgeMatrix<Dim>(frame.pose, corners).partialPivLu().solve(p - frame.pose.col(corners[0]));
    location.weights << 1 - w.sum(), w;
    return location;
}

template <int Dim>
Mat<Dim> cellRotation(const PosedFrame<Dim>& frame, int cell) {
    const Cell<Dim>& corners = frame.rest->cells[cell];
    const Mat<Dim> F =
        edgeMatrix<Dim>(frame.pose, corners) * edgeMatrix<Dim>(frame.rest->points, corners).inverse();
    const auto [U, V, sigma] = singularValueDecomposition<Dim>(F);
    return U * V.transpose();
}

template <int Dim>
std::vector<int> verticesInside(const Region<Dim>& region, const SimplicialMesh<Dim>& rest) {
    std::vector<int> vertices;
    for (int v = 0; v < rest.vertexCount(); ++v)
        if (signedDistance<Dim>(region, rest.points.col(v)) <= 0) vertices.push_back(v);
    return vertices;
}

template <int Dim>
CarryingOf<Dim> carryingBetween(const std::vector<Vec<Dim>>& rest, const std::vector<Vec<Dim>>& posed) {
    CarryingOf<Dim> carrying;
    const auto count = static_cast<Eigen::Index>(std::min(rest.size(), posed.size()));
    if (count == 0) return carrying;
    Vec<Dim> from = Vec<Dim>::Zero(), to = Vec<Dim>::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
        from += rest[i] / double(count);
        to += posed[i] / double(count);
    }
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Dim>;
    Rows X(count, Dim), Y(count, Dim);
    for (Eigen::Index i = 0; i < count; ++i) {
        X.row(i) = (rest[i] - from).transpose();
        Y.row(i) = (posed[i] - to).transpose();
    }
    if (count > Dim)
        if (const auto [map, rank] = leastSquares<Dim, Dim>(X, Y, kFlatPoints); rank == Dim)
            carrying.A = map.transpose();
    carrying.b = to - carrying.A * from;
    return carrying;
}

template Location<2> locationIn<2>(const PosedFrame<2>&, int, const Vec<2>&);
template Location<3> locationIn<3>(const PosedFrame<3>&, int, const Vec<3>&);
template Mat<2> cellRotation<2>(const PosedFrame<2>&, int);
template Mat<3> cellRotation<3>(const PosedFrame<3>&, int);
template std::vector<int> verticesInside<2>(const Region<2>&, const SimplicialMesh<2>&);
template std::vector<int> verticesInside<3>(const Region<3>&, const SimplicialMesh<3>&);
template CarryingOf<2> carryingBetween<2>(const std::vector<Vec<2>>&, const std::vector<Vec<2>>&);
template CarryingOf<3> carryingBetween<3>(const std::vector<Vec<3>>&, const std::vector<Vec<3>>&);

CarryingOf<3> carryingOf(const PosedFrame<3>& frame, const std::vector<int>& vertices) {
    std::vector<Vec<3>> rest, posed;
    for (const int v : vertices) {
        rest.push_back(frame.rest->points.col(v));
        posed.push_back(frame.pose.col(v));
    }
    return carryingBetween<3>(rest, posed);
}

SolidSize sizeOf(const PosedFrame<3>& frame, const Points<3>& points) {
    return sizeWhere(frame, points, std::vector<bool>(frame.rest->vertexCount(), true));
}

SolidSize sizeOf(const PosedFrame<3>& frame, const Points<3>& points, const std::vector<int>& vertices) {
    std::vector<bool> in(frame.rest->vertexCount(), false);
    for (const int v : vertices) in[v] = true;
    return sizeWhere(frame, points, in);
}

}  // namespace wend
