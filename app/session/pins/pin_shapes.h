#pragma once

#include "app/session/pins.h"

namespace wend {

class ShapeSession;

/// Returns one path for all points of a handle.
inline std::vector<Vec3> shownStarts(const std::vector<Vec3>& starts) {
    constexpr std::size_t kMost = 3;
    return starts.size() <= kMost ? starts : std::vector<Vec3>{meanOf(starts)};
}

/// Widens a pin to a disc or ball, or reduces it to a point for radius 0. Returns false and emits a notice if
/// the radius is too small to contain a vertex. Consecutive changes with the same `key` merge into one step.
bool widenPin(ShapeSession& session, int handle, double radius, const QString& key = {});

/// Returns whether the pin holds a single point, which turns with the shape around it.
bool holdsPoint(const ShapeSession& session, int handle);

/// Widens a pin that is a point to the smallest disc or ball that can turn. Returns false and emits a notice
/// if it is locked.
bool widenPoint(ShapeSession& session, int handle);

/// Returns the angle by which the shape is rotated at the pin in the frame that is shown.
double angleAt(const ShapeSession& session, int handle);

/// Makes the selected point of a picture hold the angle that the shape has there now, or lets it turn with
/// the shape again; one undo step.
void setHoldsAngle(ShapeSession& session, int handle, bool holds);
/// Widens a selected pin that is a point of a picture, as widenPoint() does, and rotates its disc to the
/// angle that the shape has there.
bool widenTurned(ShapeSession& session, int handle);

/// Returns whether the last path of the single selected handle can become a Bézier curve.
bool canMakeCurve(const ShapeSession& session);
/// Makes it one; one undo step.
void makeCurve(ShapeSession& session);

}  // namespace wend
