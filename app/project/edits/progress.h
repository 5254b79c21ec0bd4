#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/project/edits/key_edits.h"
#include "app/project/pin.h"

namespace wend {

/// How far a handle has come between two key poses, as the share p(s) of its way at the share s of the time:
/// a cubic Bézier curve whose handles are at thirds of the time,
///   p(s) = 3 s (1 − s)² first + 3 s² (1 − s) second + s³.
/// The four easings are such curves. Any other one of a straight move is a Bézier curve on its line, whose
/// inner points have these shares: no other kind of motion is needed.
struct Progress {
    double first = 1.0 / 3, second = 2.0 / 3;
    bool operator==(const Progress&) const = default;

    double at(double s) const;
    /// Return the speeds at both ends, relative to that of an even move.
    double startSpeed() const { return 3 * first; }
    double endSpeed() const { return 3 * (1 - second); }
};
Progress progressOf(Ease ease);
/// Returns the easing that has this progress, up to rounding.
std::optional<Ease> easeOf(const Progress& progress);

/// Returns the progress of a motion on a straight line; nothing for any other motion.
std::optional<Progress> straightProgress(const PinMotion& motion);
/// Returns a straight move from a place: with one of the four easings if it has that progress.
PinMotion straightMove(const Vec3& by, const MotionTime& time, const Progress& progress, const Vec3& place);
/// Returns the control points of a motion that is one cubic of the time, relative to its start; nothing for
/// any other motion.
std::optional<std::array<Vec3, 4>> cubicOf(const PinMotion& motion);
/// A cubic of the time: its control points relative to the start of a motion that it belongs to.
struct TimedCubic {
    std::array<Vec3, 4> points;
    MotionTime time;
};
/// Returns the cubics of the time that a motion consists of, one after another: also those of a polyline that
/// is eased. None for any other motion. An eased curve of higher order is none: the cubics of its parameter,
/// which is a quadratic or cubic of the time, are of the sixth or ninth order in time.
std::vector<TimedCubic> cubicsOf(const PinMotion& motion);
/// Returns the motion along a cubic of the time: a straight move where it is one.
PinMotion cubicMove(const std::array<Vec3, 4>& points, const MotionTime& time);

/// Says on which sides a motion is slow; those of one that is not eased by a curve are its easing's.
struct SlowSides {
    bool start = false, end = false;
    bool operator==(const SlowSides&) const = default;
};
SlowSides slowSidesOf(const PinMotion& motion);
/// Lets a motion be slow on these sides.
void setSlowSides(PinMotion& motion, const SlowSides& sides);

/// The progress of a motion as a curve editor shows it.
struct ShownProgress {
    Progress curve;
    std::vector<double> way;  // the shares of its way at even times, if these differ from the curve
    bool isFree = false;      // it may have any curve rather than one of the four easings only
};
/// Returns the progress of a motion. That of a recording or a drawn path is the curve nearest to the length
/// of its path over time.
ShownProgress shownProgress(const Design& design, const MotionId& motion);
/// Returns the motions between these keys. Where none is between two of them, it is the motion that begins at
/// the key, or else that which ends there.
std::vector<MotionId> motionsBetween(const Design& design, const std::vector<KeyId>& keys);
/// Gives motions another progress at the same times. Straight moves stay straight; a recording keeps its path
/// and loses its rhythm, and so does a drawn path unless it gets one of the four easings. Others have these
/// only. `starts` are the places of all handles at their beginning.
Design withProgress(const Design& design, const std::vector<MotionId>& motions, const Progress& progress,
                    const std::vector<Vec3>& starts);

}  // namespace wend
