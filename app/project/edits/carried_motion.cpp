#include "app/project/edits/carried_motion.h"

#include "app/project/file/named_places.h"

namespace wend {
namespace {

template <int Dim>
void carryAll(std::vector<Vec<Dim>>& points, const Carrying<Dim>& carry) {
    for (Vec<Dim>& p : points) p = carry(p);
}

template <int Dim>
void change(Translate<Dim>& move, const Carrying<Dim>& carry) {
    move.by *= carry.scale;
}
template <int Dim>
void change(Rotate<Dim>& rotate, const Carrying<Dim>& carry) {
    rotate.centre = carry(rotate.centre);
}
template <int Dim>
void change(CurveMotion<Dim>& curve, const Carrying<Dim>& carry) {
    carryAll<Dim>(curve.points, carry);
}
template <int Dim>
void change(Recorded<Dim>& stroke, const Carrying<Dim>& carry) {
    carryAll<Dim>(stroke.points, carry);
}
template <int Dim>
void change(FieldMotion<Dim>& motion, const Carrying<Dim>& carry) {
    auto values = std::make_shared<Displacements<Dim>>(*motion.values);
    for (auto& [vertex, displacement] : *values) displacement *= carry.scale;
    motion = {"", "", std::move(values)};
}
/// Carries the places of the body; its rotations are the same.
template <int Dim>
void change(PoseMotion<Dim>& motion, const Carrying<Dim>& carry) {
    motion.file.clear();
    for (RigidPose<Dim>& pose : motion.poses) pose.position = carry(pose.position);
}

void change(Polygon& polygon, const Carrying<2>& carry) {
    carryAll<2>(polygon.points, carry);
}
template <int Dim>
void change(Ball<Dim>& ball, const Carrying<Dim>& carry) {
    ball.centre = carry(ball.centre);
    ball.radius *= carry.scale;
}
template <int Dim>
void change(Box<Dim>& box, const Carrying<Dim>& carry) {
    box = {carry(box.min), carry(box.max)};
}
template <int Dim>
void change(HalfSpace<Dim>& half, const Carrying<Dim>& carry) {
    half.point = carry(half.point);
}
template <int Dim>
void change(Blend<Dim>& blend, const Carrying<Dim>& carry) {
    blend = {carry(blend.from), carry(blend.to)};
}

}  // namespace

template <int Dim>
Motion<Dim> carried(const Motion<Dim>& motion, const Carrying<Dim>& carry) {
    Motion<Dim> image = motion;
    image.extras = withoutNames(image.extras);
    std::visit([&carry](auto& kind) { change(kind, carry); }, image.kind);
    return image;
}

template <int Dim>
Region<Dim> carried(const Region<Dim>& region, const Carrying<Dim>& carry) {
    Region<Dim> image = region;
    std::visit([&carry](auto& shape) { change(shape, carry); }, image);
    return image;
}

template Region<2> carried<2>(const Region<2>&, const Carrying<2>&);
template Region<3> carried<3>(const Region<3>&, const Carrying<3>&);
template Motion<2> carried<2>(const Motion<2>&, const Carrying<2>&);
template Motion<3> carried<3>(const Motion<3>&, const Carrying<3>&);

}  // namespace wend
