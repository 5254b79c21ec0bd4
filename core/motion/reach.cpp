#include "core/motion/reach.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/motion/easing.h"

namespace wend {
namespace {

/// Returns D(t), see reachOf().
template <int Dim>
double done(const Handle<Dim>& handle, double t) {
    double sum = 0;
    for (const Motion<Dim>& motion : handle.motions) {
        const double length = motion.end - motion.start;
        const double from = std::clamp(handle.activeFrom, motion.start, motion.end),
                     to = std::clamp(std::min(handle.activeTo, t), from, motion.end);
        const auto share = [&](double time) { return ease(motion.ease, (time - motion.start) / length); };
        if (length > 0) sum += length * (share(to) - share(from));
    }
    return sum;
}

}  // namespace

template <int Dim>
double reachOf(const Handle<Dim>& handle, double t) {
    const double all = done(handle, std::numeric_limits<double>::infinity());
    return all > 0 ? done(handle, t) / all : 1;
}

template <int Dim>
double lastMotionEnd(const std::vector<Handle<Dim>>& handles, double none) {
    std::optional<double> last;
    for (const Handle<Dim>& handle : handles)
        for (const Motion<Dim>& motion : handle.motions)
            last = std::max(last.value_or(motion.end), motion.end);
    return last.value_or(none);
}

template double reachOf<2>(const Handle<2>&, double);
template double reachOf<3>(const Handle<3>&, double);
template double lastMotionEnd<2>(const std::vector<Handle<2>>&, double);
template double lastMotionEnd<3>(const std::vector<Handle<3>>&, double);

}  // namespace wend
