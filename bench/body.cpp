#include "bench/body.h"

#include <numbers>

#include "core/meshing/planar_mesher.h"
#include "core/meshing/volume_mesher.h"

namespace wend {
namespace {

constexpr double kLength = 4;

template <int Dim>
Rotate<Dim> halfTurn(double length, double width) {
    Rotate<Dim> turn;
    turn.angle = std::numbers::pi;
    if constexpr (Dim == 2) {
        turn.centre = {length / 2, width / 2 + length / std::numbers::pi};
    } else {
        turn.centre = {length, width / 2, width / 2};
        turn.axis = Vec3::UnitX();
    }
    return turn;
}

template <int Dim>
HalfSpace<Dim> end(double x, double side) {
    HalfSpace<Dim> half{Vec<Dim>::Zero(), Vec<Dim>::Zero()};
    half.point.x() = x;
    half.normal.x() = side;
    return half;
}

}  // namespace

SimplicialMesh<2> meshBox(const Vec2& size, int vertices) {
    PlanarMeshOptions options;
    options.vertices = vertices;
    return meshOutline(Outline{{{{0, 0}, {size.x(), 0}, {size.x(), size.y()}, {0, size.y()}}}}, options);
}

SimplicialMesh<3> meshBox(const Vec3& size, int vertices) {
    Surface box;
    box.points.resize(3, 8);
    for (int i = 0; i < 8; ++i) box.points.col(i) = size.cwiseProduct(Vec3(i & 1, (i >> 1) & 1, i >> 2));
    box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    VolumeMeshOptions options;
    options.vertices = vertices;
    options.keepSurface = false;
    return meshVolume(box, options).mesh;
}

template <int Dim>
Body<Dim> makeBody(int vertices) {
    Vec<Dim> box = Vec<Dim>::Ones();
    box.x() = kLength;
    SimplicialMesh<Dim> mesh = meshBox(box, vertices);
    mesh.points /= boundingBoxDiagonal<Dim>(mesh.points);
    const double length = mesh.points.row(0).maxCoeff(), width = mesh.points.row(1).maxCoeff();
    Body<Dim> body;
    body.rest = std::make_shared<const SimplicialMesh<Dim>>(std::move(mesh));
    const Rotate<Dim> turn = halfTurn<Dim>(length, width);
    body.centre = turn.centre;
    Handle<Dim> left{"left", end<Dim>(1e-9, -1), {}}, right{"right", end<Dim>(length - 1e-9, 1), {}};
    right.motions.push_back({turn});
    body.handles = {left, right};
    return body;
}

template <int Dim>
BodyRows<Dim> startRows(const Body<Dim>& body) {
    const Points<Dim>& points = body.rest->points;
    const double length = points.row(0).maxCoeff();
    std::vector<Vec<Dim>> velocities;
    BodyRows<Dim> result;
    for (int v = 0; v < body.rest->vertexCount(); ++v) {
        const Vec<Dim> p = points.col(v);
        if (p.x() > 1e-9 && p.x() < length - 1e-9) continue;
        result.rows.push_back({{{v, 1.0}}});
        const Vec<Dim> arm = p - body.centre;
        Vec<Dim> velocity = Vec<Dim>::Zero();
        // The turn is in the plane of the last two axes: xy in 2D, yz in 3D.
        if (p.x() > 1e-9) velocity.template tail<2>() = Vec2(-arm[Dim - 1], arm[Dim - 2]);
        velocities.push_back(std::numbers::pi * velocity);
    }
    result.velocities.resize(Dim, static_cast<Eigen::Index>(velocities.size()));
    for (std::size_t i = 0; i < velocities.size(); ++i)
        result.velocities.col(static_cast<Eigen::Index>(i)) = velocities[i];
    return result;
}

template struct Body<2>;
template struct Body<3>;
template Body<2> makeBody<2>(int);
template Body<3> makeBody<3>(int);
template BodyRows<2> startRows<2>(const Body<2>&);
template BodyRows<3> startRows<3>(const Body<3>&);

}  // namespace wend
