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

bool samePoints(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return sameList(a, b, [](const Vec3& p, const Vec3& q) { return p == q; });
}

bool same(const Polygon& a, const Polygon& b) {
    return a == b;
}
bool same(const Ball<3>& a, const Ball<3>& b) {
    return a.centre == b.centre && a.radius == b.radius;
}
bool same(const Box<3>& a, const Box<3>& b) {
    return a.min == b.min && a.max == b.max;
}
bool same(const HalfSpace<3>& a, const HalfSpace<3>& b) {
    return a.point == b.point && a.normal == b.normal;
}
bool same(const Blend<3>& a, const Blend<3>& b) {
    return a.from == b.from && a.to == b.to;
}
bool same(const Translate<3>& a, const Translate<3>& b) {
    return a.by == b.by;
}
bool same(const Rotate<3>& a, const Rotate<3>& b) {
    return a.centre == b.centre && a.axis == b.axis && a.angle == b.angle;
}
bool same(const CurveMotion<3>& a, const CurveMotion<3>& b) {
    return a.interpolation == b.interpolation && samePoints(a.points, b.points) && a.frame == b.frame &&
           a.twist == b.twist && a.scale == b.scale;
}
bool same(const Recorded<3>& a, const Recorded<3>& b) {
    return a.times == b.times && samePoints(a.points, b.points);
}
bool same(const FieldMotion<3>& a, const FieldMotion<3>& b) {
    return a.file == b.file && a.array == b.array && (a.values == b.values || *a.values == *b.values);
}
bool same(const PoseMotion<3>& a, const PoseMotion<3>& b) {
    return a.file == b.file && a.times == b.times &&
           sameList(a.poses, b.poses, [](const RigidPose<3>& p, const RigidPose<3>& q) {
               return p.position == q.position && p.rotation == q.rotation;
           });
}
bool same(const std::vector<int>& a, const std::vector<int>& b) {
    return a == b;
}
bool same(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return samePoints(a, b);
}

bool same(const std::shared_ptr<const GuideMesh<3>>& a, const std::shared_ptr<const GuideMesh<3>>& b) {
    return a == b || (a && b && a->points.cols() == b->points.cols() && a->points == b->points &&
                      a->triangles == b->triangles && a->segments == b->segments);
}

template <class... T>
bool same(const std::variant<T...>& a, const std::variant<T...>& b) {
    if (a.index() != b.index()) return false;
    return std::visit(
        [&b](const auto& value) { return same(value, std::get<std::decay_t<decltype(value)>>(b)); }, a);
}

bool same(const PinMotion& a, const PinMotion& b) {
    return a.start == b.start && a.end == b.end && a.ease == b.ease && same(a.kind, b.kind);
}

/// Returns whether one motion is the other one cut off at its end, so that both agree until then. Not for
/// decelerating motions, which become linear when cut, nor for splines, whose pieces get other times. The
/// relation is not symmetric: the integrator stops at the end of the cut motion but not there on the whole
/// one.
bool isCutOff(const PinMotion& motion, const PinMotion& whole) {
    const auto* curve = std::get_if<CurveMotion<3>>(&whole.kind);
    const bool keepsTimes = (whole.ease == Ease::Linear || whole.ease == Ease::In) &&
                            (!curve || curve->interpolation != Interpolation::Spline);
    if (!keepsTimes || motion.end <= whole.start || motion.end >= whole.end) return false;
    Pin handle;
    handle.motions = {whole};
    endMotionsAt(handle, motion.end);
    return handle.motions.size() == 1 && same(handle.motions[0], motion);
}

/// Returns whether a body that follows all motions of either handle is at the same place at a time.
bool samePlaceAt(const Pin& a, const Pin& b, double time) {
    const auto at = [time](const Pin& handle) {
        return HandleTimeline<3>(handleIn<3>(handle)).bodyAt(time, Side::Before).position;
    };
    const AffineMap<3> p = at(a), q = at(b);
    const double way = std::max(p.b.norm(), q.b.norm());
    return (p.A - q.A).norm() <= kRounding && (p.b - q.b).norm() <= kRounding * way;
}

double lastOf(const Pin& a, const Pin& b) {
    if (!samePlace(a, b) || a.activeFrom != b.activeFrom || a.activeTo != b.activeTo) return kNever;
    std::size_t i = a.motions.size(), j = b.motions.size();
    while (i > 0 && j > 0 && same(a.motions[i - 1], b.motions[j - 1])) --i, --j;
    double last = -kNever;
    for (std::size_t k = 0; k < i; ++k) last = std::max(last, a.motions[k].end);
    for (std::size_t k = 0; k < j; ++k) last = std::max(last, b.motions[k].end);
    const auto isField = [](const PinMotion& motion) {
        return std::holds_alternative<FieldMotion<3>>(motion.kind);
    };
    if (std::ranges::any_of(a.motions, isField) || std::ranges::any_of(b.motions, isField))
        return i + j > 0 ? kNever : last;
    return i + j == 0 || samePlaceAt(a, b, last) ? last : kNever;
}

/// Compares two lists of handles with different clocks.
class Comparison {
  public:
    explicit Comparison(double scale) : m_scale(scale) {}

    double first(const Pin& a, const Pin& b) const {
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
    bool sameMotion(const PinMotion& a, const PinMotion& b) const {
        return sameAs(a.start, b.start) && sameAs(a.end, b.end) && a.ease == b.ease && same(a.kind, b.kind);
    }

    double m_scale;
};

}  // namespace

bool sameTime(double a, double b) {
    if (!std::isfinite(a) || !std::isfinite(b)) return a == b;
    return std::abs(a - b) <= kRounding * std::max({1.0, std::abs(a), std::abs(b)});
}

bool samePlace(const Pin& a, const Pin& b) {
    const bool sameSurface = a.slide && b.slide
                                 ? a.slide->file == b.slide->file && same(a.slide->mesh, b.slide->mesh)
                                 : !a.slide && !b.slide;
    return same(a.at, b.at) && a.part == b.part && a.slides == b.slides && a.normal == b.normal &&
           sameSurface;
}

double timeScale(const std::vector<Pin>& a, const std::vector<Pin>& b) {
    const PinMotion *was = nullptr, *is = nullptr;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (a[i].motions.empty() || b[i].motions.empty()) continue;
        if (was && was->end <= a[i].motions[0].end) continue;
        was = &a[i].motions[0];
        is = &b[i].motions[0];
    }
    if (was && isCutOff(*is, *was)) return 1;
    return was && was->end > 0 && is->end > 0 ? is->end / was->end : 1;
}

double firstDifference(const std::vector<Pin>& a, const std::vector<Pin>& b, double scale) {
    const Comparison comparison(scale);
    const std::size_t common = std::min(a.size(), b.size());
    double first = kNever;
    for (std::size_t i = 0; i < common; ++i) first = std::min(first, comparison.first(a[i], b[i]));
    for (std::size_t i = common; i < a.size(); ++i) first = std::min(first, scale * a[i].activeFrom);
    for (std::size_t i = common; i < b.size(); ++i) first = std::min(first, b[i].activeFrom);
    return first;
}

double lastDifference(const std::vector<Pin>& a, const std::vector<Pin>& b) {
    if (a.size() != b.size()) return kNever;
    double last = -kNever;
    for (std::size_t i = 0; i < a.size(); ++i) last = std::max(last, lastOf(a[i], b[i]));
    return last;
}

}  // namespace wend
