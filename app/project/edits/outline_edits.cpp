#include "app/project/edits/outline_edits.h"

#include "app/project/project.h"
#include "core/mesh/segments.h"
#include "core/meshing/outline_combination.h"

namespace wend {

namespace {

constexpr double kOnLine = 1e-9;  // pixels

bool isOn(const Outline& outline, const Vec<2>& p) {
    for (const auto& loop : outline.loops)
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (distanceToSegment<2>(p, loop[k], loop[(k + 1) % loop.size()]) <= kOnLine) return true;
    return false;
}

}  // namespace

namespace {

/// Removes points of handles outside an outline, and handles without points; of one part, or of all.
int removeOutside(Project& project, const Outline& outline, const std::string* part) {
    auto& handles = project.design.handles;
    const auto counts = [part](const Pin& handle) { return !part || handle.part == *part; };
    for (Pin& handle : handles)
        if (auto* points = std::get_if<std::vector<Vec3>>(&handle.at); points && counts(handle))
            std::erase_if(*points, [&](const Vec3& p) {
                return !isInside(outline, inPlane(p)) && !isOn(outline, inPlane(p));
            });
    return static_cast<int>(std::erase_if(handles, [](const Pin& handle) {
        const auto* points = std::get_if<std::vector<Vec3>>(&handle.at);
        return points && points->empty();
    }));
}

}  // namespace

int setOutline(Project& project, Outline outline) {
    const int gone = removeOutside(project, outline, nullptr);
    project.domain.outline = OutlineKind::Polygons;
    project.domain.polygons = std::move(outline);
    return gone;
}

std::shared_ptr<const Project> withDrawnOutline(const Project& project, int part, Outline outline,
                                                int& pinsGone) {
    auto next = copyOf(project);
    PicturePart& own = next->domain.parts.at(static_cast<std::size_t>(part));
    pinsGone = removeOutside(*next, outline, &own.name);
    own.outline = PartOutline{OutlineKind::Polygons, {}, std::move(outline)};
    return next;
}

}  // namespace wend
