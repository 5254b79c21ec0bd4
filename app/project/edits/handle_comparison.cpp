#include "app/project/edits/handle_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/project/edits/film_time.h"
#include "core/motion/constraints.h"

namespace wend {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;

template <class T, class Same>
bool sameList(const std::vector<T>& a, const std::vector<T>& b, Same same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

template <int Dim>
bool samePoints(const std::vector<Vec<Dim>>& a, const std::vector<Vec<Dim>>& b) {
    return sameList(a, b, [](const Vec<Dim>& p, const Vec<Dim>& q) { return p == q; });
}

bool same(const Polygon& a, const Polygon& b) {
    return samePoints<2>(a.points, b.points);
}
template <int Dim>
bool same(const Ball<Dim>& a, const Ball<Dim>& b) {
    return a.centre == b.centre && a.radius == b.radius;
}
template <int Dim>
bool same(const Box<Dim>& a, const Box<Dim>& b) {
    return a.min == b.min && a.max == b.max;
}
template <int Dim>
bool same(const HalfSpace<Dim>& a, const HalfSpace<Dim>& b) {
    return a.point == b.point && a.normal == b.normal;
}
template <int Dim>
bool same(const Blend<Dim>& a, const Blend<Dim>& b) {
    return a.from == b.from && a.to == b.to;
}
template <int Dim>
bool same(const Translate<Dim>& a, const Translate<Dim>& b) {
    return a.by == b.by;
}
template <int Dim>
bool same(const Rotate<Dim>& a, const Rotate<Dim>& b) {
    return a.centre == b.centre && a.axis == b.axis && a.angle == b.angle;
}
template <int Dim>
bool same(const CurveMotion<Dim>& a, const CurveMotion<Dim>& b) {
    return a.interpolation == b.interpolation && samePoints<Dim>(a.points, b.points) && a.frame == b.frame &&
           a.twist == b.twist && a.scale == b.scale;
}
template <int Dim>
bool same(const Recorded<Dim>& a, const Recorded<Dim>& b) {
    return a.times == b.times && samePoints<Dim>(a.points, b.points);
}
template <int Dim>
bool same(const FieldMotion<Dim>& a, const FieldMotion<Dim>& b) {
    return a.file == b.file && a.array == b.array && (a.values == b.values || *a.values == *b.values);
}
template <int Dim>
bool same(const PoseMotion<Dim>& a, const PoseMotion<Dim>& b) {
    return a.file == b.file && a.times == b.times &&
           sameList(a.poses, b.poses, [](const RigidPose<Dim>& p, const RigidPose<Dim>& q) {
               return p.position == q.position && p.rotation == q.rotation;
           });
}
bool same(const std::vector<int>& a, const std::vector<int>& b) {
    return a == b;
}
template <int Dim>
bool same(const std::vector<Vec<Dim>>& a, const std::vector<Vec<Dim>>& b) {
    return samePoints<Dim>(a, b);
}

template <class... T>
bool same(const std::variant<T...>& a, const std::variant<T...>& b) {
    if (a.index() != b.index()) return false;
    return std::visit(
        [&b](const auto& value) { return same(value, std::get<std::decay_t<decltype(value)>>(b)); }, a);
}

template <int Dim>
bool same(const Motion<Dim>& a, const Motion<Dim>& b) {
    return a.start == b.start && a.end == b.end && a.ease == b.ease && same(a.kind, b.kind);
}

/// Returns whether one motion is the other one cut off at its end, so that both agree until then. Not for
/// decelerating motions, which become linear when cut, nor for splines, whose pieces get other times. The
/// relation is not symmetric: the integrator stops at the end of the cut motion but not there on the whole
/// one.
template <int Dim>
bool isCutOff(const Motion<Dim>& motion, const Motion<Dim>& whole) {
    const auto* curve = std::get_if<CurveMotion<Dim>>(&whole.kind);
    const bool keepsTimes = (whole.ease == Ease::Linear || whole.ease == Ease::In) &&
                            (!curve || curve->interpolation != Interpolation::Spline);
    if (!keepsTimes || motion.end <= whole.start || motion.end >= whole.end) return false;
    Handle<Dim> handle;
    handle.motions = {whole};
    endMotionsAt(handle, motion.end);
    return handle.motions.size() == 1 && same(handle.motions[0], motion);
}

/// Returns whether a body that follows all motions of either handle is at the same place at a time.
template <int Dim>
bool samePlaceAt(const Handle<Dim>& a, const Handle<Dim>& b, double time) {
    const auto at = [time](const Handle<Dim>& handle) {
        return HandleTimeline<Dim>(handle).bodyAt(time, Side::Before).position;
    };
    const AffineMap<Dim> p = at(a), q = at(b);
    const double way = std::max(p.b.norm(), q.b.norm());
    return (p.A - q.A).norm() <= kRounding && (p.b - q.b).norm() <= kRounding * way;
}

template <int Dim>
double lastOf(const Handle<Dim>& a, const Handle<Dim>& b) {
    if (!samePlace(a, b) || a.activeFrom != b.activeFrom || a.activeTo != b.activeTo) return kNever;
    std::size_t i = a.motions.size(), j = b.motions.size();
    while (i > 0 && j > 0 && same(a.motions[i - 1], b.motions[j - 1])) --i, --j;
    double last = -kNever;
    for (std::size_t k = 0; k < i; ++k) last = std::max(last, a.motions[k].end);
    for (std::size_t k = 0; k < j; ++k) last = std::max(last, b.motions[k].end);
    const auto isField = [](const Motion<Dim>& motion) {
        return std::holds_alternative<FieldMotion<Dim>>(motion.kind);
    };
    if (std::ranges::any_of(a.motions, isField) || std::ranges::any_of(b.motions, isField))
        return i + j > 0 ? kNever : last;
    return i + j == 0 || samePlaceAt(a, b, last) ? last : kNever;
}

/// Compares two lists of handles with different clocks.
template <int Dim>
class Comparison {
  public:
    explicit Comparison(double scale) : m_scale(scale) {}

    double first(const Handle<Dim>& a, const Handle<Dim>& b) const {
        if (!samePlace(a, b) || !sameAs(a.activeFrom, b.activeFrom))
            return std::min(m_scale * a.activeFrom, b.activeFrom);
        double first = sameAs(a.activeTo, b.activeTo) ? kNever : std::min(m_scale * a.activeTo, b.activeTo);
        const std::size_t common = std::min(a.motions.size(), b.motions.size());
        std::size_t i = 0;
        while (i < common && sameMotion(a.motions[i], b.motions[i])) ++i;
        if (i < common && m_scale == 1 && isCutOff(b.motions[i], a.motions[i]))
            return std::min(first, b.motions[i].end);
        if (i < a.motions.size()) first = std::min(first, m_scale * a.motions[i].start);
        if (i < b.motions.size()) first = std::min(first, b.motions[i].start);
        return first;
    }

  private:
    bool sameAs(double a, double b) const { return m_scale == 1 ? a == b : sameTime(m_scale * a, b); }
    bool sameMotion(const Motion<Dim>& a, const Motion<Dim>& b) const {
        return sameAs(a.start, b.start) && sameAs(a.end, b.end) && a.ease == b.ease && same(a.kind, b.kind);
    }

    double m_scale;
};

}  // namespace

bool sameTime(double a, double b) {
    if (!std::isfinite(a) || !std::isfinite(b)) return a == b;
    return std::abs(a - b) <= kRounding * std::max({1.0, std::abs(a), std::abs(b)});
}

template <int Dim>
bool samePlace(const Handle<Dim>& a, const Handle<Dim>& b) {
    const bool sameSurface = a.slide && b.slide
                                 ? a.slide->file == b.slide->file && a.slide->mesh == b.slide->mesh
                                 : !a.slide && !b.slide;
    return same(a.at, b.at) && a.part == b.part && a.slides == b.slides && a.normal == b.normal &&
           sameSurface;
}

template <int Dim>
double timeScale(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b) {
    const Motion<Dim>*was = nullptr, *is = nullptr;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (a[i].motions.empty() || b[i].motions.empty()) continue;
        if (was && was->end <= a[i].motions[0].end) continue;
        was = &a[i].motions[0];
        is = &b[i].motions[0];
    }
    if (was && isCutOff(*is, *was)) return 1;
    return was && was->end > 0 && is->end > 0 ? is->end / was->end : 1;
}

template <int Dim>
double firstDifference(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b, double scale) {
    const Comparison<Dim> comparison(scale);
    const std::size_t common = std::min(a.size(), b.size());
    double first = kNever;
    for (std::size_t i = 0; i < common; ++i) first = std::min(first, comparison.first(a[i], b[i]));
    for (std::size_t i = common; i < a.size(); ++i) first = std::min(first, scale * a[i].activeFrom);
    for (std::size_t i = common; i < b.size(); ++i) first = std::min(first, b[i].activeFrom);
    return first;
}

template <int Dim>
double lastDifference(const std::vector<Handle<Dim>>& a, const std::vector<Handle<Dim>>& b) {
    if (a.size() != b.size()) return kNever;
    double last = -kNever;
    for (std::size_t i = 0; i < a.size(); ++i) last = std::max(last, lastOf(a[i], b[i]));
    return last;
}

#define WEND_INSTANTIATE(Dim)                                                                              \
    template bool samePlace(const Handle<Dim>&, const Handle<Dim>&);                                       \
    template double lastDifference<Dim>(const std::vector<Handle<Dim>>&, const std::vector<Handle<Dim>>&); \
    template double timeScale<Dim>(const std::vector<Handle<Dim>>&, const std::vector<Handle<Dim>>&);      \
    template double firstDifference<Dim>(const std::vector<Handle<Dim>>&, const std::vector<Handle<Dim>>&, \
                                         double)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
