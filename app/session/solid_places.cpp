#include "app/session/solid_places.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace wend {

namespace {

constexpr double kFlat = 1e-6;  // of the extent: below it points lie in a plane

Mat<3> edgesOf(const Points<3>& points, const Cell<3>& cell) {
    Mat<3> edges;
    for (int k = 0; k < 3; ++k) edges.col(k) = points.col(cell[k + 1]) - points.col(cell[0]);
    return edges;
}

SolidSize sizeWhere(const PosedFrame<3>& frame, const Points<3>& points, const std::vector<bool>& in) {
    const auto all = [&in](const auto& vertices) {
        return std::all_of(vertices.begin(), vertices.end(), [&in](int v) { return in[v]; });
    };
    SolidSize size;
    for (const Cell<3>& cell : frame.rest->cells)
        if (all(cell)) size.volume += std::abs(cellMeasure<3>(points, cell));
    for (const Facet<3>& facet : *frame.facets) {
        if (facet.interior() || !all(facet.vertices)) continue;
        const Vec<3> a = points.col(facet.vertices[0]);
        const Vec<3> u = points.col(facet.vertices[1]) - a, v = points.col(facet.vertices[2]) - a;
        size.area += u.cross(v).norm() / 2;
    }
    return size;
}

}  // namespace

Location<3> locationIn(const PosedFrame<3>& frame, int cell, const Vec<3>& p) {
    Location<3> location;
    location.cell = cell;
    const Cell<3>& corners = frame.rest->cells[cell];
    const Vec<3> w = edgesOf(frame.pose, corners).partialPivLu().solve(p - frame.pose.col(corners[0]));
    location.weights << 1 - w.sum(), w;
    return location;
}

Mat<3> cellRotation(const PosedFrame<3>& frame, int cell) {
    const Cell<3>& corners = frame.rest->cells[cell];
    const Mat<3> F = edgesOf(frame.pose, corners) * edgesOf(frame.rest->points, corners).inverse();
    const Eigen::JacobiSVD<Mat<3>> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
}

std::vector<int> verticesIn(const Region<3>& region, const SimplicialMesh<3>& rest) {
    std::vector<int> vertices;
    for (int v = 0; v < rest.vertexCount(); ++v)
        if (signedDistance<3>(region, rest.points.col(v)) <= 0) vertices.push_back(v);
    return vertices;
}

Carrying carryingOf(const std::vector<Vec<3>>& rest, const std::vector<Vec<3>>& posed) {
    Carrying carrying;
    const auto count = static_cast<Eigen::Index>(std::min(rest.size(), posed.size()));
    if (count == 0) return carrying;
    Vec<3> from = Vec<3>::Zero(), to = Vec<3>::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
        from += rest[i] / double(count);
        to += posed[i] / double(count);
    }
    Eigen::MatrixX3d X(count, 3), Y(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
        X.row(i) = (rest[i] - from).transpose();
        Y.row(i) = (posed[i] - to).transpose();
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> solver;
    solver.setThreshold(kFlat);
    if (count >= 4 && solver.compute(X).rank() == 3) carrying.A = solver.solve(Y).transpose();
    carrying.b = to - carrying.A * from;
    return carrying;
}

Carrying carryingOf(const PosedFrame<3>& frame, const std::vector<int>& vertices) {
    std::vector<Vec<3>> rest, posed;
    for (const int v : vertices) {
        rest.push_back(frame.rest->points.col(v));
        posed.push_back(frame.pose.col(v));
    }
    return carryingOf(rest, posed);
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
