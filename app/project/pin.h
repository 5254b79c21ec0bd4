#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/project/extras.h"
#include "app/project/id.h"
#include "core/motion/handle.h"

namespace wend {

/// Motions and handles as projects have them: in the coordinates of space, with z = 0 in pictures, where
/// rotations are about +z.
struct PinMotion : Motion<3> {
    Extras extras = {};
};

/// Properties of a handle for editing; the shape does not depend on them.
struct PinTraits {
    bool locked = false;                  // is neither moved nor removed
    bool hidden = false;                  // is neither drawn nor picked; it holds all the same
    std::string group;                    // handles of one name belong together; empty: to none
    int link = 0;                         // handles of one number move together; 0: alone
    std::optional<unsigned> colour = {};  // 0xRRGGBB; by its place in the list without one
    bool operator==(const PinTraits&) const = default;
};

/// See Handle, whose fields it has.
struct Pin {
    std::string name;
    Placement<3> at;
    std::vector<PinMotion> motions;
    double activeFrom = -std::numeric_limits<double>::infinity();
    double activeTo = std::numeric_limits<double>::infinity();
    unsigned slides = 0;
    std::optional<Vec3> normal = {};
    std::optional<Slide<3>> slide = {};
    std::string part = {};
    PinTraits traits = {};
    Extras extras = {};
    Id id = newId();

    bool isPartlyHeld() const { return slides != 0 || normal || slide; }
};

/// Return what the engine takes of them, in the coordinates of a dimension, exactly.
template <int Dim>
Placement<Dim> placementIn(const Placement<3>& at);
template <int Dim>
Motion<Dim> motionIn(const PinMotion& motion);
template <int Dim>
Handle<Dim> handleIn(const Pin& pin);
template <int Dim>
std::vector<Handle<Dim>> handlesIn(const std::vector<Pin>& pins) {
    std::vector<Handle<Dim>> handles;
    for (const Pin& pin : pins) handles.push_back(handleIn<Dim>(pin));
    return handles;
}
/// Return the same in the coordinates of space.
Placement<3> inSpace(const Placement<2>& at);
inline const Placement<3>& inSpace(const Placement<3>& at) {
    return at;
}
Pin inSpace(const Handle<2>& handle);
Pin inSpace(const Handle<3>& handle);

/// Returns a surface in the coordinates of that dimension.
template <int Dim>
GuideMesh<Dim> guideIn(const GuideMesh<3>& mesh) {
    return {mesh.points.topRows<Dim>(), mesh.triangles, mesh.segments};
}

}  // namespace wend
