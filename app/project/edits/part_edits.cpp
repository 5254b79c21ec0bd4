#include "app/project/edits/part_edits.h"

#include <algorithm>
#include <utility>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/project.h"
#include "core/mesh/segments.h"
#include "core/meshing/outline_combination.h"

namespace wend {

namespace {

constexpr int kGroundVertices = 200;  // of a part that does not bend
constexpr double kSoftEdge = 0.02;    // of full opacity: what of a soft edge is still drawn

constexpr double kOnLine = 1e-9;  // pixels

bool isOn(const Outline& outline, const Vec2& p) {
    for (const auto& loop : outline.loops)
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (distanceToSegment<2>(p, loop[k], loop[(k + 1) % loop.size()]) <= kOnLine) return true;
    return false;
}

}  // namespace

std::vector<PicturePart> withPartMoved(std::vector<PicturePart> parts, int from, int to) {
    const auto begin = parts.begin();
    if (from < to)
        std::rotate(begin + from, begin + from + 1, begin + to + 1);
    else
        std::rotate(begin + to, begin + from, begin + from + 1);
    return parts;
}

std::shared_ptr<const Project> withPartName(const Project& project, int part, const std::string& name) {
    auto next = copyOf(project);
    std::vector<PicturePart>& parts = domainOf(*next).parts;
    const std::string before = parts.at(static_cast<std::size_t>(part)).name;
    const auto rename = [&](std::string& reference) {
        if (reference == before) reference = name;
    };
    for (PicturePart& one : parts) {
        rename(one.name);
        rename(one.cutFrom);
        rename(one.ridesOn);
        for (Joint& joint : one.joints) rename(joint.to);
    }
    for (Pin& handle : designOf(*next).handles) rename(handle.part);
    for (MaterialRegion& region : regionsOf(designOf(*next).material.layers)) rename(region.part);
    for (SoftRegion& region : regionsOf(depthOf(*next))) rename(region.part);
    for (SoftRegion& region : regionsOf(domainOf(*next).sizes)) rename(region.part);
    return next;
}

std::shared_ptr<const Project> withNewPart(const Project& project, const NewPart& made) {
    auto next = copyOf(project);
    Domain& domain = domainOf(*next);
    if (domain.parts.empty()) {
        PicturePart& whole = domain.parts.emplace_back();
        whole.name = made.from;
        whole.path = std::exchange(domain.path, {});
        if (made.heldGround) whole.vertices = kGroundVertices;
    }
    PicturePart part;
    part.name = made.name;
    part.cutFrom = made.from;
    part.cut = made.cut;
    part.feather = made.feather;
    part.fill = true;
    part.outline = PartOutline{OutlineKind::Alpha, {}, {}};
    part.outline->alpha.threshold = kSoftEdge;
    if (made.joint) part.joints.push_back({made.from, *made.joint});
    domain.parts.insert(std::ranges::find(domain.parts, made.from, &PicturePart::name), std::move(part));
    if (made.heldGround) {
        Pin& ground = designOf(*next).handles.emplace_back();
        ground.name = ground.part = made.from;
        ground.at = Region<3>(*made.heldGround);
        ground.traits.locked = true;  // a drag beside the new part would take it along
    }
    return next;
}

bool isProtected(const std::vector<PicturePart>& parts, const std::string& name) {
    const auto part = std::ranges::find(parts, name, &PicturePart::name);
    return part != parts.end() && (part->locked || part->hidden);
}

int partCount(const Project& project) {
    return static_cast<int>(domainOf(project).parts.size());
}

std::shared_ptr<Project> asWhole(const Project& project, int part) {
    auto whole = copyOf(project);
    Domain& domain = domainOf(*whole);
    const PicturePart own = domain.parts.at(static_cast<std::size_t>(part));
    if (own.vertices > 0) domain.vertices = own.vertices;
    if (!own.outline) return whole;
    domain.outline = own.outline->kind;
    domain.alpha = own.outline->alpha;
    domain.polygons = own.outline->polygons;
    return whole;
}

std::shared_ptr<const Project> withPartOutline(const Project& project, int part, PartOutline outline) {
    auto next = copyOf(project);
    domainOf(*next).parts.at(static_cast<std::size_t>(part)).outline = std::move(outline);
    return next;
}

std::shared_ptr<const Project> withPartVertices(const Project& project, int part, int vertices) {
    auto next = copyOf(project);
    domainOf(*next).parts.at(static_cast<std::size_t>(part)).vertices = vertices;
    return next;
}

bool hasOwnOutline(const PicturePart& part) {
    return part.vertices > 0 || (part.cutFrom.empty() && part.outline);
}

std::shared_ptr<const Project> withoutOwnOutline(const Project& project, int part) {
    auto next = copyOf(project);
    PicturePart& own = domainOf(*next).parts.at(static_cast<std::size_t>(part));
    own.vertices = 0;
    if (own.cutFrom.empty()) own.outline.reset();
    return next;
}

std::shared_ptr<const Project> withPartInFront(const Project& project, int part, double time, bool front) {
    auto next = copyOf(project);
    std::vector<PicturePart>& parts = domainOf(*next).parts;
    double least = 0, most = static_cast<double>(parts.size()) - 1;
    for (const PicturePart& one : parts)
        for (const PartOrder& order : one.order) {
            least = std::min(least, order.place);
            most = std::max(most, order.place);
        }
    std::vector<PartOrder>& order = parts.at(static_cast<std::size_t>(part)).order;
    std::erase_if(order, [time](const PartOrder& one) { return one.time == time; });
    const auto later = std::ranges::find_if(order, [time](const PartOrder& one) { return one.time > time; });
    order.insert(later, {time, front ? least - 1 : most + 1});
    return next;
}

std::shared_ptr<const Project> withoutParts(const Project& project, const std::string& path) {
    auto next = copyOf(project);
    domainOf(*next).parts.clear();
    domainOf(*next).path = path;
    for (Pin& handle : designOf(*next).handles) handle.part.clear();
    for (MaterialRegion& region : regionsOf(designOf(*next).material.layers)) region.part.clear();
    for (SoftRegion& region : regionsOf(depthOf(*next))) region.part.clear();
    for (SoftRegion& region : regionsOf(domainOf(*next).sizes)) region.part.clear();
    return next;
}

bool mayRide(const std::vector<PicturePart>& parts, int part, int on) {
    const PicturePart& rider = parts.at(static_cast<std::size_t>(part));
    const auto isJoined = [&](const PicturePart& other) {
        return std::ranges::any_of(other.joints, [&](const Joint& joint) { return joint.to == rider.name; });
    };
    if (!rider.joints.empty() || std::ranges::any_of(parts, isJoined)) return false;
    const PicturePart* host = &parts.at(static_cast<std::size_t>(on));
    while (host != &rider && !host->ridesOn.empty())
        host = &*std::ranges::find(parts, host->ridesOn, &PicturePart::name);
    return host != &rider;
}

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
