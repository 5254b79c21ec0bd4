#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/motion/handle.h"

namespace wend {

/// The path of a motion that only translates: offsets from its start, by time; linear in between.
template <int Dim>
struct OffsetPath {
    std::vector<double> times;
    std::vector<Vec<Dim>> offsets;

    Vec<Dim> at(double time) const;
    /// Returns the offsets plus a displacement, times a factor that is linear in time.
    OffsetPath led(const Vec<Dim>& by, double first, double last) const;
};

/// Returns the path of a motion that only translates, exact at one time; nothing for any other motion.
template <int Dim>
std::optional<OffsetPath<Dim>> offsetPathOf(const Motion<Dim>& motion, double time);
/// Returns the offset from the start to the end of such a motion.
template <int Dim>
std::optional<Vec<Dim>> offsetOf(const Motion<Dim>& motion);
/// Returns both parts of a path that is split at a time within it.
template <int Dim>
std::pair<OffsetPath<Dim>, OffsetPath<Dim>> split(const OffsetPath<Dim>& path, double time);
/// Returns a motion along a path from a place.
template <int Dim>
Motion<Dim> motionAlong(const OffsetPath<Dim>& path, const Vec<Dim>& place);
/// Returns the motion with a displacement times a factor from `first` to `last`, starting at a place. One
/// that is straight, or a chain of cubics, stays so, with its easing. Nothing for motions that do not only
/// translate.
template <int Dim>
std::optional<Motion<Dim>> led(const Motion<Dim>& motion, const Vec<Dim>& by, double first, double last,
                               const Vec<Dim>& place);

}  // namespace wend
