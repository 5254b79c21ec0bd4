#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/motion/handle.h"

namespace wend {

/// The way of a motion that only translates: offsets from its start, by time; linear in between.
template <int Dim>
struct MotionWay {
    std::vector<double> times;
    std::vector<Vec<Dim>> offsets;

    Vec<Dim> at(double time) const;
    /// Returns the offsets plus a displacement, times a factor that is linear in time.
    MotionWay led(const Vec<Dim>& by, double first, double last) const;
};

/// Returns the way of a motion that only translates, exact at one time; nothing for any other motion.
template <int Dim>
std::optional<MotionWay<Dim>> wayOf(const Motion<Dim>& motion, double time);
/// Returns the offset from the start to the end of such a motion.
template <int Dim>
std::optional<Vec<Dim>> offsetOf(const Motion<Dim>& motion);
/// Returns both parts of a way that is split at a time within it.
template <int Dim>
std::pair<MotionWay<Dim>, MotionWay<Dim>> split(const MotionWay<Dim>& way, double time);
/// Returns a motion along a way from a place.
template <int Dim>
Motion<Dim> motionAlong(const MotionWay<Dim>& way, const Vec<Dim>& place);
/// Returns the motion with a displacement times a factor from `first` to `last`, starting at a place. One
/// that is straight stays so, with its easing. Nothing for motions that do not only translate.
template <int Dim>
std::optional<Motion<Dim>> led(const Motion<Dim>& motion, const Vec<Dim>& by, double first, double last,
                               const Vec<Dim>& place);

}  // namespace wend
