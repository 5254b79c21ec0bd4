#include "app/document/edits/simplify_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "app/document/design.h"
#include "app/document/edits/motion_way.h"
#include "core/motion/easing.h"

namespace wend {

namespace {

constexpr std::array kFits = {Ease::Linear, Ease::InOut, Ease::In, Ease::Out};

/// Returns whether a straight motion is near a part of a way at its samples, between which both are smooth.
template <int Dim>
bool fits(const MotionWay<Dim>& way, std::size_t from, std::size_t to, Ease kind, double tolerance) {
    const Vec<Dim>& start = way.offsets[from];
    const Vec<Dim> by = way.offsets[to] - start;
    for (std::size_t i = from + 1; i < to; ++i) {
        const double s = (way.times[i] - way.times[from]) / (way.times[to] - way.times[from]);
        if ((start + ease(kind, s) * by - way.offsets[i]).norm() > tolerance) return false;
    }
    return true;
}

/// Returns the straight motions along a way, each as long as possible.
template <int Dim>
std::vector<Motion<Dim>> straightParts(const MotionWay<Dim>& way, double tolerance) {
    std::vector<Motion<Dim>> parts;
    const std::size_t last = way.times.size() - 1;
    for (std::size_t from = 0, to = last; from < last; from = to, to = last) {
        auto kind = kFits.end();
        const auto find = [&] {
            kind = std::ranges::find_if(kFits,
                                        [&](Ease one) { return fits<Dim>(way, from, to, one, tolerance); });
            return kind != kFits.end();
        };
        while (!find()) --to;
        parts.push_back(
            {Translate<Dim>{way.offsets[to] - way.offsets[from]}, way.times[from], way.times[to], *kind});
    }
    return parts;
}

/// Returns the way with samples that are close enough for the easing between them.
template <int Dim>
MotionWay<Dim> refined(const MotionWay<Dim>& way) {
    constexpr int kLeast = 64;
    const double step = (way.times.back() - way.times.front()) / kLeast;
    MotionWay<Dim> fine;
    for (std::size_t i = 0; i + 1 < way.times.size(); ++i) {
        const int parts = 1 + static_cast<int>((way.times[i + 1] - way.times[i]) / step);
        for (int k = 0; k < parts; ++k) {
            fine.times.push_back(std::lerp(way.times[i], way.times[i + 1], double(k) / parts));
            fine.offsets.push_back(k == 0 ? way.offsets[i] : way.at(fine.times.back()));
        }
    }
    fine.times.push_back(way.times.back());
    fine.offsets.push_back(way.offsets.back());
    return fine;
}

template <int Dim>
void divide(std::vector<Motion<Dim>>& motions, int at, double tolerance) {
    const Motion<Dim>& own = motions.at(static_cast<std::size_t>(at));
    if (std::holds_alternative<Translate<Dim>>(own.kind)) return;
    const auto way = wayOf<Dim>(own, own.end);
    if (!way) return;
    std::vector<Motion<Dim>> parts = straightParts<Dim>(refined<Dim>(*way), tolerance);
    parts.front().start = own.start;
    parts.back().end = own.end;
    motions.erase(motions.begin() + at);
    motions.insert(motions.begin() + at, parts.begin(), parts.end());
}

template <class Edit>
AnyDesign edited(AnyDesign design, const std::vector<MotionId>& motions, const Edit& edit) {
    std::visit(
        [&](auto& own) {
            for (const MotionId& id : motions)
                edit(own.handles.at(static_cast<std::size_t>(id.handle)).motions, id.motion);
        },
        design);
    return design;
}

template <int Dim>
void straighten(std::vector<Motion<Dim>>& motions, int at) {
    Motion<Dim>& own = motions.at(static_cast<std::size_t>(at));
    if (const auto offset = offsetOf<Dim>(own)) own.kind = Translate<Dim>{*offset};
}

}  // namespace

AnyDesign straightened(const AnyDesign& design, const std::vector<MotionId>& motions) {
    return edited(design, motions, [](auto& own, int at) { straighten(own, at); });
}

AnyDesign withFewKeys(const AnyDesign& design, std::vector<MotionId> motions, double tolerance) {
    std::ranges::sort(motions, std::greater());  // the later ones first: the others keep their places
    return edited(design, motions, [=](auto& own, int at) { divide(own, at, tolerance); });
}

}  // namespace wend
