#include "app/project/edits/simplify_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "app/project/design.h"
#include "app/project/edits/offset_path.h"
#include "core/motion/easing.h"

namespace wend {

namespace {

constexpr std::array kFits = {Ease::Linear, Ease::InOut, Ease::In, Ease::Out};

/// Returns whether a straight motion is near a part of a path at its samples, between which both are smooth.
bool fits(const OffsetPath& path, std::size_t from, std::size_t to, Ease kind, double tolerance) {
    const Vec3& start = path.offsets[from];
    const Vec3 by = path.offsets[to] - start;
    for (std::size_t i = from + 1; i < to; ++i) {
        const double s = (path.times[i] - path.times[from]) / (path.times[to] - path.times[from]);
        if ((start + ease(kind, s) * by - path.offsets[i]).norm() > tolerance) return false;
    }
    return true;
}

/// Returns the straight motions along a path, each as long as possible.
std::vector<PinMotion> straightParts(const OffsetPath& path, double tolerance) {
    std::vector<PinMotion> parts;
    const std::size_t last = path.times.size() - 1;
    for (std::size_t from = 0, to = last; from < last; from = to, to = last) {
        auto kind = kFits.end();
        const auto find = [&] {
            kind =
                std::ranges::find_if(kFits, [&](Ease one) { return fits(path, from, to, one, tolerance); });
            return kind != kFits.end();
        };
        while (!find()) --to;
        parts.push_back(
            {Translate<3>{path.offsets[to] - path.offsets[from]}, path.times[from], path.times[to], *kind});
    }
    return parts;
}

/// Returns the path with samples that are close enough for the easing between them.
OffsetPath refined(const OffsetPath& path) {
    constexpr int kLeast = 64;
    const double step = (path.times.back() - path.times.front()) / kLeast;
    OffsetPath fine;
    for (std::size_t i = 0; i + 1 < path.times.size(); ++i) {
        const int parts = 1 + static_cast<int>((path.times[i + 1] - path.times[i]) / step);
        for (int k = 0; k < parts; ++k) {
            fine.times.push_back(std::lerp(path.times[i], path.times[i + 1], double(k) / parts));
            fine.offsets.push_back(k == 0 ? path.offsets[i] : path.at(fine.times.back()));
        }
    }
    fine.times.push_back(path.times.back());
    fine.offsets.push_back(path.offsets.back());
    return fine;
}

void divide(std::vector<PinMotion>& motions, int at, double tolerance) {
    const PinMotion& own = motions.at(static_cast<std::size_t>(at));
    if (std::holds_alternative<Translate<3>>(own.kind)) return;
    const auto path = offsetPathOf(own, own.end);
    if (!path) return;
    std::vector<PinMotion> parts = straightParts(refined(*path), tolerance);
    parts.front().start = own.start;
    parts.back().end = own.end;
    motions.erase(motions.begin() + at);
    motions.insert(motions.begin() + at, parts.begin(), parts.end());
}

template <class Edit>
Design edited(Design design, const std::vector<MotionId>& motions, const Edit& edit) {
    for (const MotionId& id : motions)
        edit(design.handles.at(static_cast<std::size_t>(id.handle)).motions, id.motion);
    return design;
}

void straighten(std::vector<PinMotion>& motions, int at) {
    PinMotion& own = motions.at(static_cast<std::size_t>(at));
    if (const auto offset = offsetOf(own)) own.kind = Translate<3>{*offset};
}

}  // namespace

Design straightened(const Design& design, const std::vector<MotionId>& motions) {
    return edited(design, motions, [](auto& own, int at) { straighten(own, at); });
}

Design withFewKeys(const Design& design, std::vector<MotionId> motions, double tolerance) {
    std::ranges::sort(motions, std::greater());  // the later ones first: the others keep their places
    return edited(design, motions, [=](auto& own, int at) { divide(own, at, tolerance); });
}

}  // namespace wend
