#include "app/project/edits/value_edits.h"

#include <QCoreApplication>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/project/design.h"
#include "app/project/edits/free_name.h"

namespace wend {

namespace {

constexpr double kSamePlaces = 1e-9;  // a stroke over the very same places
constexpr double kReach = 0.2;        // of the shape's size, around points

/// Returns whether a ball of a stroke covers a region, including both soft edges.
bool covers(const SoftRegion& stroke, const SoftRegion& region) {
    const auto* ball = std::get_if<Ball<3>>(&stroke.shape);
    const auto* own = std::get_if<Ball<3>>(&region.shape);
    return ball && own && (stroke.part.empty() || stroke.part == region.part) &&
           (ball->centre - own->centre).norm() + own->radius + region.feather / 2 <=
               (1 + kSamePlaces) * ball->radius - stroke.feather / 2;
}

/// Adds a stroke in place of what it covers, unless it is as everywhere and nothing is left to change.
ValueLayers withValueStroke(ValueLayers layers, const QString& kind, std::vector<SoftRegion> stroke,
                            double value, double elsewhere) {
    for (ValueLayer& layer : layers)
        std::erase_if(layer.regions, [&](const SoftRegion& region) {
            return std::ranges::any_of(stroke, [&](const SoftRegion& one) { return covers(one, region); });
        });
    std::erase_if(layers, [](const ValueLayer& layer) { return layer.regions.empty(); });
    if (layers.empty() && value == elsewhere) return layers;
    const std::string name = freeName(namesOf(layers), kind.toStdString());
    layers.push_back({name, value, std::move(stroke)});
    return layers;
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

ValueLayers withSizeStroke(ValueLayers sizes, std::vector<SoftRegion> stroke, double factor) {
    return withValueStroke(std::move(sizes), QCoreApplication::translate("Names", "Stroke"),
                           std::move(stroke), factor, 1);
}

ValueLayers withSizeRegion(ValueLayers sizes, const Region<3>& shape, double factor) {
    const std::string kind = QCoreApplication::translate("Names", "Region").toStdString();
    sizes.push_back({freeName(namesOf(sizes), kind), factor, {{shape}}});
    return sizes;
}

ValueLayers withDepthStroke(ValueLayers depth, std::vector<SoftRegion> stroke, double order) {
    return withValueStroke(std::move(depth), QCoreApplication::translate("Names", "Depth"), std::move(stroke),
                           order, 0);
}

ValueLayers withHandleDepth(ValueLayers depth, const Design& design, const std::vector<int>& handles,
                            double order, double size) {
    for (const int h : handles) {
        const std::string& name = design.handles[h].name;
        std::erase_if(depth, [&](const ValueLayer& layer) { return !name.empty() && layer.name == name; });
        if (order == 0) continue;
        bool isFirst = true;
        for (const Region<3>& shape : shapesOf(design.handles, h, size)) {
            if (std::exchange(isFirst, false) || name.empty()) depth.push_back({name, order, {}});
            depth.back().regions.push_back({shape, 0, design.handles[h].part});
        }
    }
    return depth;
}

std::optional<double> depthOfHandle(const ValueLayers& depth, const std::string& name) {
    for (const ValueLayer& layer : depth)
        if (!name.empty() && layer.name == name) return layer.value;
    return {};
}

}  // namespace wend
