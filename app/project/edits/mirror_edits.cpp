#include "app/project/edits/mirror_edits.h"

namespace wend {

namespace {

void mirrorAll(std::vector<Vec3>& points, const Mirror& mirror) {
    for (Vec3& p : points) p = mirror(p);
}

void change(Translate<3>& move, const Mirror& mirror) {
    move.by = mirror.along(move.by);
}
/// Mirrors an axis of rotation: a = −S a for the reflection S. One that stays in place keeps its direction,
/// as in pictures, where rotations are about +z.
void change(Rotate<3>& rotate, const Mirror& mirror) {
    rotate.centre = mirror(rotate.centre);
    const Vec3 axis = mirror.along(rotate.axis);
    if (axis == rotate.axis)
        rotate.angle = -rotate.angle;
    else
        rotate.axis = -axis;
}
void change(CurveMotion<3>& curve, const Mirror& mirror) {
    mirrorAll(curve.points, mirror);
    curve.twist = -curve.twist;
}
void change(Recorded<3>& stroke, const Mirror& mirror) {
    mirrorAll(stroke.points, mirror);
}

/// Mirrors the displacements, not the vertices. They differ from those of the file, which is named no more.
void change(FieldMotion<3>& motion, const Mirror& mirror) {
    auto values = std::make_shared<Displacements<3>>(*motion.values);
    for (auto& [vertex, displacement] : *values) displacement = mirror.along(displacement);
    motion = {"", "", std::move(values)};
}
/// The rotation S R S of a reflection S has the vector −S w.
void change(PoseMotion<3>& motion, const Mirror& mirror) {
    motion.file.clear();
    for (RigidPose<3>& pose : motion.poses) {
        pose.position = mirror(pose.position);
        pose.rotation = -mirror.along(pose.rotation);
    }
}

void change(Polygon& polygon, const Mirror& mirror) {
    for (Vec<2>& p : polygon.points) p = inPlane(mirror(inSpace(p)));
}
void change(Ball<3>& ball, const Mirror& mirror) {
    ball.centre = mirror(ball.centre);
}
void change(Box<3>& box, const Mirror& mirror) {
    const Vec3 a = mirror(box.min), b = mirror(box.max);
    box = {a.cwiseMin(b), a.cwiseMax(b)};
}
void change(HalfSpace<3>& half, const Mirror& mirror) {
    half = {mirror(half.point), mirror.along(half.normal)};
}
void change(Blend<3>& blend, const Mirror& mirror) {
    blend = {mirror(blend.from), mirror(blend.to)};
}

}  // namespace

Vec3 Mirror::operator()(Vec3 p) const {
    p[axis] = 2 * at - p[axis];
    return p;
}

Vec3 Mirror::along(Vec3 direction) const {
    direction[axis] = -direction[axis];
    return direction;
}

PinMotion mirrored(const PinMotion& motion, const Mirror& mirror) {
    PinMotion image = motion;
    std::visit([&mirror](auto& kind) { change(kind, mirror); }, image.kind);
    return image;
}

Region<3> mirrored(const Region<3>& region, const Mirror& mirror) {
    Region<3> image = region;
    std::visit([&mirror](auto& shape) { change(shape, mirror); }, image);
    return image;
}

}  // namespace wend
