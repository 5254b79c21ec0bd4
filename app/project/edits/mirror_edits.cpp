#include "app/project/edits/mirror_edits.h"

namespace wend {

namespace {

template <int Dim>
void mirrorAll(std::vector<Vec<Dim>>& points, const Mirror<Dim>& mirror) {
    for (Vec<Dim>& p : points) p = mirror(p);
}

template <int Dim>
void change(Translate<Dim>& move, const Mirror<Dim>& mirror) {
    move.by = mirror.along(move.by);
}
/// Mirrors an axis of rotation: a = −S a for the reflection S.
template <int Dim>
void change(Rotate<Dim>& rotate, const Mirror<Dim>& mirror) {
    rotate.centre = mirror(rotate.centre);
    if (Dim == 2)
        rotate.angle = -rotate.angle;
    else
        rotate.axis = -mirror.along(rotate.axis);
}
template <int Dim>
void change(CurveMotion<Dim>& curve, const Mirror<Dim>& mirror) {
    mirrorAll(curve.points, mirror);
    curve.twist = -curve.twist;
}
template <int Dim>
void change(Recorded<Dim>& stroke, const Mirror<Dim>& mirror) {
    mirrorAll(stroke.points, mirror);
}

/// Mirrors the displacements, not the vertices. They differ from those of the file, which is named no more.
template <int Dim>
void change(FieldMotion<Dim>& motion, const Mirror<Dim>& mirror) {
    auto values = std::make_shared<Displacements<Dim>>(*motion.values);
    for (auto& [vertex, displacement] : *values) displacement = mirror.along(displacement);
    motion = {"", "", std::move(values)};
}
/// The rotation S R S of a reflection S has the vector −S w.
template <int Dim>
void change(PoseMotion<Dim>& motion, const Mirror<Dim>& mirror) {
    motion.file.clear();
    for (RigidPose<Dim>& pose : motion.poses) {
        pose.position = mirror(pose.position);
        if constexpr (Dim == 2)
            pose.rotation = -pose.rotation;
        else
            pose.rotation = -mirror.along(pose.rotation);
    }
}

void change(Polygon& polygon, const Mirror<2>& mirror) {
    mirrorAll(polygon.points, mirror);
}
template <int Dim>
void change(Ball<Dim>& ball, const Mirror<Dim>& mirror) {
    ball.centre = mirror(ball.centre);
}
template <int Dim>
void change(Box<Dim>& box, const Mirror<Dim>& mirror) {
    const Vec<Dim> a = mirror(box.min), b = mirror(box.max);
    box = {a.cwiseMin(b), a.cwiseMax(b)};
}
template <int Dim>
void change(HalfSpace<Dim>& half, const Mirror<Dim>& mirror) {
    half = {mirror(half.point), mirror.along(half.normal)};
}
template <int Dim>
void change(Blend<Dim>& blend, const Mirror<Dim>& mirror) {
    blend = {mirror(blend.from), mirror(blend.to)};
}

}  // namespace

template <int Dim>
Vec<Dim> Mirror<Dim>::operator()(Vec<Dim> p) const {
    p[axis] = 2 * at - p[axis];
    return p;
}

template <int Dim>
Vec<Dim> Mirror<Dim>::along(Vec<Dim> direction) const {
    direction[axis] = -direction[axis];
    return direction;
}

template <int Dim>
Motion<Dim> mirrored(const Motion<Dim>& motion, const Mirror<Dim>& mirror) {
    Motion<Dim> image = motion;
    std::visit([&mirror](auto& kind) { change(kind, mirror); }, image.kind);
    return image;
}

template <int Dim>
Region<Dim> mirrored(const Region<Dim>& region, const Mirror<Dim>& mirror) {
    Region<Dim> image = region;
    std::visit([&mirror](auto& shape) { change(shape, mirror); }, image);
    return image;
}

#define WEND_INSTANTIATE(Dim)                                              \
    template struct Mirror<Dim>;                                           \
    template Motion<Dim> mirrored(const Motion<Dim>&, const Mirror<Dim>&); \
    template Region<Dim> mirrored<Dim>(const Region<Dim>&, const Mirror<Dim>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
