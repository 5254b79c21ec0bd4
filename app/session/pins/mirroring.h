#pragma once

#include "app/engine/motion/frame.h"
#include "app/project/edits/key_edits.h"
#include "app/project/pin.h"

namespace wend {

class ShapeSession;

/// Mirrors one coordinate, at an upright or level line of a picture, or a plane in space across an axis.
struct Mirror {
    int axis = 0;
    double at = 0;

    /// Mirrors a place, and a direction.
    Vec3 operator()(Vec3 p) const;
    Vec3 along(Vec3 direction) const;
};

/// Returns the mirror image of the motion, with its rotations.
PinMotion mirrored(const PinMotion& motion, const Mirror& mirror);
Region<3> mirrored(const Region<3>& region, const Mirror& mirror);

/// Returns the mirror of a shape: for pictures the vertical line through the middle, for solids the
/// axis-aligned plane through the middle that makes it most similar to its mirror image (the first of
/// equals).
Mirror mirrorOf(const ShapeFrame& frame);

/// Returns for each handle the one that is nearest to its mirror image, which may be itself; itself if none
/// is near.
std::vector<int> mirrorImages(const ShapeFrame& frame, const std::vector<Pin>& handles);

/// Returns mirrored copies of key poses. Each pose is given to the pin at the mirror image of its pin, or to
/// the same pin if there is no such pin; see mirrorOf().
std::vector<CopiedKey> mirroredKeys(const ShapeFrame& frame, const std::vector<Pin>& handles,
                                    std::vector<CopiedKey> copies);

/// Adds and selects a mirrored pin with a mirrored motion for each selected pin. Emits a notice where that is
/// impossible.
void mirrorPins(ShapeSession& session);
/// Mirrors the motion of the selected pins at their start.
void mirrorMotion(ShapeSession& session);
/// Returns whether a selected pin moves.
bool canMirrorMotion(const ShapeSession& session);

}  // namespace wend
