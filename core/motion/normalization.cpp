#include "core/motion/normalization.h"

#include "core/mesh/shape_size.h"

namespace wend {

template <int Dim>
Normalization<Dim> Normalization<Dim>::of(const SimplicialMesh<Dim>& rest) {
    const ShapeSize<Dim> shape = shapeSize<Dim>(rest.points, rest.cells);
    return {shape.centroid, shape.size};
}

namespace {

/// Moves every position and length of a handle to the frame.
template <int Dim>
struct Mover {
    const Normalization<Dim>& frame;

    void operator()(std::vector<int>&) const {}
    void operator()(std::vector<Vec<Dim>>& points) const {
        for (Vec<Dim>& p : points) p = frame.normal(p);
    }
    void operator()(Region<Dim>& region) const { std::visit(*this, region); }
    void operator()(Polygon& polygon) const {
        if constexpr (Dim == 2) (*this)(polygon.points);
    }
    void operator()(Ball<Dim>& ball) const {
        ball.centre = frame.normal(ball.centre);
        ball.radius /= frame.size;
    }
    void operator()(Box<Dim>& box) const {
        box.min = frame.normal(box.min);
        box.max = frame.normal(box.max);
    }
    void operator()(HalfSpace<Dim>& half) const { half.point = frame.normal(half.point); }
    void operator()(Blend<Dim>& blend) const {
        blend.from = frame.normal(blend.from);
        blend.to = frame.normal(blend.to);
    }
    void operator()(Translate<Dim>& motion) const { motion.by /= frame.size; }
    void operator()(Rotate<Dim>& motion) const { motion.centre = frame.normal(motion.centre); }
    void operator()(CurveMotion<Dim>& motion) const { (*this)(motion.points); }
    void operator()(Recorded<Dim>& motion) const { (*this)(motion.points); }
    void operator()(FieldMotion<Dim>& motion) const {
        auto values = std::make_shared<Displacements<Dim>>(*motion.values);
        for (auto& [vertex, displacement] : *values) displacement /= frame.size;
        motion.values = std::move(values);
    }
    void operator()(PoseMotion<Dim>& motion) const {
        for (RigidPose<Dim>& pose : motion.poses) pose.position = frame.normal(pose.position);
    }
};

}  // namespace

template <int Dim>
Handle<Dim> Normalization<Dim>::normal(const Handle<Dim>& handle) const {
    Handle<Dim> result = handle;
    const Mover<Dim> mover{*this};
    std::visit(mover, result.at);
    for (Motion<Dim>& motion : result.motions) std::visit(mover, motion.kind);
    if (result.slide && result.slide->mesh) {
        auto mesh = std::make_shared<GuideMesh<Dim>>(*result.slide->mesh);
        mesh->points = normal(mesh->points);
        result.slide->mesh = std::move(mesh);
    }
    return result;
}

template struct Normalization<2>;
template struct Normalization<3>;

}  // namespace wend
