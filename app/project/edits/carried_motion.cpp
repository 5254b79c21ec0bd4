#include "app/project/edits/carried_motion.h"

#include "app/project/file/named_places.h"

namespace wend {
namespace {

void carryAll(std::vector<Vec3>& points, const Carrying& carry) {
    for (Vec3& p : points) p = carry(p);
}

void change(Translate<3>& move, const Carrying& carry) {
    move.by *= carry.scale;
}
void change(Rotate<3>& rotate, const Carrying& carry) {
    rotate.centre = carry(rotate.centre);
}
void change(CurveMotion<3>& curve, const Carrying& carry) {
    carryAll(curve.points, carry);
}
void change(Recorded<3>& stroke, const Carrying& carry) {
    carryAll(stroke.points, carry);
}
void change(FieldMotion<3>& motion, const Carrying& carry) {
    auto values = std::make_shared<Displacements<3>>(*motion.values);
    for (auto& [vertex, displacement] : *values) displacement *= carry.scale;
    motion = {"", "", std::move(values)};
}
/// Carries the places of the body; its rotations are the same.
void change(PoseMotion<3>& motion, const Carrying& carry) {
    motion.file.clear();
    for (RigidPose<3>& pose : motion.poses) pose.position = carry(pose.position);
}

void change(Polygon& polygon, const Carrying& carry) {
    for (Vec2& p : polygon.points) p = inPlane(carry(inSpace(p)));
}
void change(Ball<3>& ball, const Carrying& carry) {
    ball.centre = carry(ball.centre);
    ball.radius *= carry.scale;
}
void change(Box<3>& box, const Carrying& carry) {
    box = {carry(box.min), carry(box.max)};
}
void change(HalfSpace<3>& half, const Carrying& carry) {
    half.point = carry(half.point);
}
void change(Blend<3>& blend, const Carrying& carry) {
    blend = {carry(blend.from), carry(blend.to)};
}

}  // namespace

PinMotion carried(const PinMotion& motion, const Carrying& carry) {
    PinMotion image = motion;
    image.extras = withoutNames(image.extras);
    std::visit([&carry](auto& kind) { change(kind, carry); }, image.kind);
    return image;
}

Region<3> carried(const Region<3>& region, const Carrying& carry) {
    Region<3> image = region;
    std::visit([&carry](auto& shape) { change(shape, carry); }, image);
    return image;
}

}  // namespace wend
