#include "app/project/edits/depth_edits.h"

#include <QCoreApplication>
#include <algorithm>
#include <limits>

#include "app/project/design.h"
#include "app/project/edits/free_name.h"

namespace wend {

namespace {

constexpr double kSameStroke = 1e-9;  // a stroke over the very same places
constexpr double kReach = 0.2;        // of the shape's size, around points

bool hides(const std::vector<Ball<3>>& balls, const DepthRegion& region) {
    const auto* own = std::get_if<Ball<3>>(&region.shape);
    return own && std::ranges::any_of(balls, [&](const Ball<3>& ball) {
               return (ball.centre - own->centre).norm() + own->radius <= (1 + kSameStroke) * ball.radius;
           });
}

/// Returns the distance of a place from the nearest point of another handle.
double nearestOther(const std::vector<Pin>& handles, int handle, const Vec3& p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        if (h == handle) continue;
        if (const auto* points = std::get_if<std::vector<Vec3>>(&handles[h].at))
            for (const Vec3& q : *points) nearest = std::min(nearest, (p - q).norm());
        if (const auto* region = std::get_if<Region<3>>(&handles[h].at))
            nearest = std::min(nearest, std::max(0.0, 2 * signedDistance<3>(*region, p)));
    }
    return nearest;
}

/// Returns the regions that get a handle's depth: its own region, or discs around its points; none for
/// vertices.
std::vector<Region<3>> shapesOf(const std::vector<Pin>& handles, int handle, double size) {
    const Placement<3>& at = handles[handle].at;
    if (const auto* region = std::get_if<Region<3>>(&at)) return {*region};
    std::vector<Region<3>> shapes;
    if (const auto* points = std::get_if<std::vector<Vec3>>(&at))
        for (const Vec3& p : *points)
            if (const double radius = std::min(kReach * size, 0.5 * nearestOther(handles, handle, p));
                radius > 0)
                shapes.push_back(Ball<3>{p, radius});
    return shapes;
}

}  // namespace

DepthRegions withDepthStroke(const DepthRegions& depth, const std::vector<Ball<3>>& balls, double order,
                             const std::string& part) {
    DepthRegions next = depth;
    const std::string name =
        freeName(namesOf(depth), QCoreApplication::translate("Names", "Depth").toStdString());
    std::erase_if(next, [&](const DepthRegion& region) {
        return (part.empty() || region.part == part) && hides(balls, region);
    });
    for (const Ball<3>& ball : balls) next.push_back({name, ball, order, part});
    return next;
}

DepthRegions withHandleDepth(const DepthRegions& depth, const Design& design, const std::vector<int>& handles,
                             double order, double size) {
    DepthRegions next = depth;
    for (const int h : handles) {
        const std::string& name = design.handles[h].name;
        std::erase_if(next, [&](const DepthRegion& region) { return !name.empty() && region.name == name; });
        if (order == 0) continue;
        for (const Region<3>& shape : shapesOf(design.handles, h, size))
            next.push_back({name, shape, order, design.handles[h].part});
    }
    return next;
}

std::optional<double> depthOfHandle(const DepthRegions& depth, const std::string& name) {
    for (const DepthRegion& region : depth)
        if (!name.empty() && region.name == name) return region.order;
    return {};
}

}  // namespace wend
