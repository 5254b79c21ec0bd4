#include "app/project/pin.h"

namespace wend {
namespace {

/// Converts the parts of handles between coordinates of the plane and of space.
template <int From, int To>
struct Coordinates {
    static Vec<To> point(const Vec<From>& p) {
        if constexpr (To == 2)
            return inPlane(p);
        else
            return inSpace(p);
    }
    static Region<To> region(const Region<From>& region) {
        if constexpr (To == 2)
            return inPlane(region);
        else
            return inSpace(region);
    }
    static std::vector<Vec<To>> points(const std::vector<Vec<From>>& all) {
        std::vector<Vec<To>> result;
        result.reserve(all.size());
        for (const Vec<From>& p : all) result.push_back(point(p));
        return result;
    }

    static Translate<To> kind(const Translate<From>& move) { return {point(move.by)}; }
    static Rotate<To> kind(const Rotate<From>& rotate) {
        if constexpr (To == 2)
            return {point(rotate.centre), Vec2::Zero(), rotate.axis.z() < 0 ? -rotate.angle : rotate.angle};
        else
            return {point(rotate.centre), Vec3::UnitZ(), rotate.angle};
    }
    static CurveMotion<To> kind(const CurveMotion<From>& curve) {
        return {curve.interpolation, points(curve.points), curve.frame, curve.twist, curve.scale};
    }
    static Recorded<To> kind(const Recorded<From>& stroke) { return {stroke.times, points(stroke.points)}; }
    static FieldMotion<To> kind(const FieldMotion<From>& field) {
        Displacements<To> values;
        values.reserve(field.values->size());
        for (const auto& [vertex, by] : *field.values) values.emplace_back(vertex, point(by));
        return {field.file, field.array, std::make_shared<const Displacements<To>>(std::move(values))};
    }
    static PoseMotion<To> kind(const PoseMotion<From>& motion) {
        PoseMotion<To> result{motion.file, motion.times, {}, motion.hasOwnTimes};
        for (const RigidPose<From>& pose : motion.poses) {
            RigidPose<To>& own = result.poses.emplace_back();
            own.position = point(pose.position);
            if constexpr (To == 2)
                own.rotation[0] = pose.rotation.z();
            else
                own.rotation = {0, 0, pose.rotation[0]};
        }
        return result;
    }

    static Motion<To> motion(const Motion<From>& motion) {
        Motion<To> result{{}, motion.start, motion.end, motion.ease};
        std::visit([&](const auto& own) { result.kind = kind(own); }, motion.kind);
        return result;
    }
    static Placement<To> placement(const Placement<From>& at) {
        if (const auto* own = std::get_if<Region<From>>(&at)) return region(*own);
        if (const auto* own = std::get_if<std::vector<Vec<From>>>(&at)) return points(*own);
        return std::get<std::vector<int>>(at);
    }
    static Slide<To> slide(const Slide<From>& slide) {
        if (!slide.mesh) return {slide.file, nullptr};
        GuideMesh<To> mesh;
        mesh.points = Points<To>::Zero(To, slide.mesh->points.cols());
        mesh.points.template topRows<2>() = slide.mesh->points.template topRows<2>();
        mesh.triangles = slide.mesh->triangles;
        mesh.segments = slide.mesh->segments;
        return {slide.file, std::make_shared<const GuideMesh<To>>(std::move(mesh))};
    }
};

using Flat = Coordinates<3, 2>;
using Solid = Coordinates<2, 3>;

template <int Dim>
Pin pinOf(const Handle<Dim>& handle) {
    Pin pin{handle.name, inSpace(handle.at), {}, handle.activeFrom, handle.activeTo, handle.slides};
    if (handle.normal) pin.normal = inSpace(*handle.normal);
    pin.part = handle.part;
    return pin;
}

}  // namespace

template <int Dim>
Placement<Dim> placementIn(const Placement<3>& at) {
    if constexpr (Dim == 3)
        return at;
    else
        return Flat::placement(at);
}
template Placement<2> placementIn<2>(const Placement<3>&);
template Placement<3> placementIn<3>(const Placement<3>&);

template <int Dim>
Motion<Dim> motionIn(const PinMotion& motion) {
    if constexpr (Dim == 3)
        return motion;
    else
        return Flat::motion(motion);
}
template Motion<2> motionIn<2>(const PinMotion&);
template Motion<3> motionIn<3>(const PinMotion&);

template <int Dim>
Handle<Dim> handleIn(const Pin& pin) {
    Handle<Dim> handle{pin.name, placementIn<Dim>(pin.at), {}, pin.activeFrom, pin.activeTo, pin.slides};
    for (const PinMotion& motion : pin.motions) handle.motions.push_back(motionIn<Dim>(motion));
    if (pin.normal) handle.normal = pin.normal->template head<Dim>();
    if constexpr (Dim == 3) handle.slide = pin.slide;
    if constexpr (Dim == 2)
        if (pin.slide) handle.slide = Flat::slide(*pin.slide);
    handle.part = pin.part;
    return handle;
}
template Handle<2> handleIn<2>(const Pin&);
template Handle<3> handleIn<3>(const Pin&);

Placement<3> inSpace(const Placement<2>& at) {
    return Solid::placement(at);
}
Pin inSpace(const Handle<2>& handle) {
    Pin pin = pinOf(handle);
    for (const Motion<2>& motion : handle.motions) pin.motions.push_back({Solid::motion(motion)});
    if (handle.slide) pin.slide = Solid::slide(*handle.slide);
    return pin;
}
Pin inSpace(const Handle<3>& handle) {
    Pin pin = pinOf(handle);
    for (const Motion<3>& motion : handle.motions) pin.motions.push_back({motion});
    pin.slide = handle.slide;
    return pin;
}

}  // namespace wend
