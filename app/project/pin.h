#pragma once

#include "core/motion/handle.h"

namespace wend {

/// Handles and motions as projects have them: in the coordinates of space, with z = 0 in pictures, where
/// rotations are about +z.
using Pin = Handle<3>;
using PinMotion = Motion<3>;

/// Return what the engine takes of a picture: the same in the coordinates of the plane, exactly.
Placement<2> inPlane(const Placement<3>& at);
Motion<2> inPlane(const PinMotion& motion);
Handle<2> inPlane(const Pin& pin);
/// Return the same in the coordinates of space.
Placement<3> inSpace(const Placement<2>& at);
PinMotion inSpace(const Motion<2>& motion);
Pin inSpace(const Handle<2>& handle);
inline const Placement<3>& inSpace(const Placement<3>& at) {
    return at;
}
inline const Pin& inSpace(const Pin& pin) {
    return pin;
}

/// Returns a surface in the coordinates of that dimension.
template <int Dim>
GuideMesh<Dim> guideIn(const GuideMesh<3>& mesh) {
    return {mesh.points.topRows<Dim>(), mesh.triangles, mesh.segments};
}

/// Return places and motions in the coordinates of that dimension.
template <int Dim>
Placement<Dim> placementIn(const Placement<3>& at) {
    if constexpr (Dim == 3)
        return at;
    else
        return inPlane(at);
}
template <int Dim>
Motion<Dim> motionIn(const PinMotion& motion) {
    if constexpr (Dim == 3)
        return motion;
    else
        return inPlane(motion);
}

/// Return handles in the coordinates of that dimension.
template <int Dim>
Handle<Dim> handleIn(const Pin& pin) {
    if constexpr (Dim == 3)
        return pin;
    else
        return inPlane(pin);
}
template <int Dim>
std::vector<Handle<Dim>> handlesIn(const std::vector<Pin>& pins) {
    std::vector<Handle<Dim>> handles;
    for (const Pin& pin : pins) handles.push_back(handleIn<Dim>(pin));
    return handles;
}

}  // namespace wend
