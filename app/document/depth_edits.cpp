#include "app/document/depth_edits.h"

#include <QCoreApplication>
#include <algorithm>
#include <limits>

#include "app/document/free_name.h"
#include "app/document/project.h"

namespace wend {

namespace {

constexpr double kSame = 1e-9;  // a stroke over the very same places
constexpr double kReach = 0.2;  // of the shape's size, around points

const std::vector<Handle<2>>& handlesOf(const Project& project) {
    return std::get<Design<2>>(project.design).handles;
}

bool hides(const std::vector<Ball<2>>& balls, const DepthRegion& region) {
    const auto* own = std::get_if<Ball<2>>(&region.shape);
    return own && std::ranges::any_of(balls, [&](const Ball<2>& ball) {
               return (ball.centre - own->centre).norm() + own->radius <= (1 + kSame) * ball.radius;
           });
}

/// How far a place is from the nearest point of another handle.
double nearestOther(const Project& project, int handle, const Vec<2>& p) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto& handles = handlesOf(project);
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        if (h == handle) continue;
        if (const auto* points = std::get_if<std::vector<Vec<2>>>(&handles[h].at))
            for (const Vec<2>& q : *points) nearest = std::min(nearest, (p - q).norm());
        if (const auto* region = std::get_if<Region<2>>(&handles[h].at))
            nearest = std::min(nearest, std::max(0.0, 2 * signedDistance<2>(*region, p)));
    }
    return nearest;
}

/// What a handle brings along: its own region, or a circle around its points; nothing for vertices.
std::vector<Region<2>> shapesOf(const Project& project, int handle, double size) {
    const Placement<2>& at = handlesOf(project)[handle].at;
    if (const auto* region = std::get_if<Region<2>>(&at)) return {*region};
    std::vector<Region<2>> shapes;
    if (const auto* points = std::get_if<std::vector<Vec<2>>>(&at))
        for (const Vec<2>& p : *points)
            if (const double radius = std::min(kReach * size, 0.5 * nearestOther(project, handle, p));
                radius > 0)
                shapes.push_back(Ball<2>{p, radius});
    return shapes;
}

}  // namespace

Project withDepthStroke(const Project& project, const std::vector<Ball<2>>& balls, double order) {
    Project next = project;
    const std::string name =
        freeName(namesOf(project.depth), QCoreApplication::translate("Names", "Depth").toStdString());
    std::erase_if(next.depth, [&](const DepthRegion& region) { return hides(balls, region); });
    for (const Ball<2>& ball : balls) next.depth.push_back({name, ball, order});
    return next;
}

Project withHandleDepth(const Project& project, const std::vector<int>& handles, double order, double size) {
    Project next = project;
    for (const int h : handles) {
        const std::string& name = handlesOf(project)[h].name;
        next = withoutDepth(next, name);
        if (order == 0) continue;
        for (const Region<2>& shape : shapesOf(project, h, size)) next.depth.push_back({name, shape, order});
    }
    return next;
}

std::optional<double> depthOfHandle(const Project& project, int handle) {
    const std::string& name = handlesOf(project)[handle].name;
    for (const DepthRegion& region : project.depth)
        if (!name.empty() && region.name == name) return region.order;
    return {};
}

Project withoutDepth(const Project& project, const std::string& name) {
    Project next = project;
    std::erase_if(next.depth,
                  [&](const DepthRegion& region) { return !name.empty() && region.name == name; });
    return next;
}

}  // namespace wend
