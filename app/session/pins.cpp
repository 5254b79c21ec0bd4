#include "app/session/pins.h"

#include <algorithm>

#include "app/document/handle_edits.h"
#include "core/mesh/region.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr int kPathSamples = 60;  // per motion

/// Every vertex as a location: the corner of the first cell that has it.
std::vector<Location<2>> vertexLocations(const SimplicialMesh<2>& rest) {
    std::vector<Location<2>> all(rest.vertexCount());
    for (int c = 0; c < rest.cellCount(); ++c)
        for (int k = 0; k < 3; ++k) {
            Location<2>& location = all[rest.cells[c][k]];
            if (location.cell >= 0) continue;
            location.cell = c;
            location.weights.setZero();
            location.weights[k] = 1;
        }
    return all;
}

class Placer {
  public:
    Placer(const SimplicialMesh<2>& rest, const PointLocator<2>& locator)
        : m_rest(rest), m_locator(locator), m_vertices(vertexLocations(rest)) {}

    PinPlace operator()(const std::vector<int>& vertices) const {
        PinPlace place;
        for (const int v : vertices)
            if (v >= 0 && v < m_rest.vertexCount()) place.points.push_back(m_vertices[v]);
        return place;
    }
    PinPlace operator()(const std::vector<Vec<2>>& points) const {
        PinPlace place;
        for (const Vec<2>& p : points)
            if (const auto location = m_locator.find(p, 1e-9)) place.points.push_back(*location);
        return place;
    }
    PinPlace operator()(const Region<2>& region) const {
        PinPlace place;
        place.region = true;
        for (int v = 0; v < m_rest.vertexCount(); ++v)
            if (signedDistance<2>(region, m_rest.points.col(v)) <= 0) place.points.push_back(m_vertices[v]);
        return place;
    }

  private:
    const SimplicialMesh<2>& m_rest;
    const PointLocator<2>& m_locator;
    std::vector<Location<2>> m_vertices;
};

Vec<2> meanOf(const std::vector<Vec<2>>& points) {
    Vec<2> sum = Vec<2>::Zero();
    for (const Vec<2>& p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

void appendMotion(const Motion<2>& motion, PinPath& path) {
    const Trajectory<2> trajectory(motion);
    const Vec<2> from = path.points.back();
    for (int i = 0; i <= kPathSamples; ++i) {
        const double t = motion.start + (motion.end - motion.start) * i / kPathSamples;
        path.points.push_back(trajectory.at(t).position(from));
        path.times.push_back(t);
    }
}

}  // namespace

std::vector<PinPlace> placePins(const std::vector<Handle<2>>& handles, const SimplicialMesh<2>& rest,
                                const PointLocator<2>& locator) {
    const Placer placer(rest, locator);
    std::vector<PinPlace> places;
    for (const Handle<2>& handle : handles) places.push_back(std::visit(placer, handle.at));
    return places;
}

Vec<2> positionOf(const Location<2>& location, const SimplicialMesh<2>& rest, const Points<2>& pose) {
    Vec<2> p = Vec<2>::Zero();
    for (int k = 0; k < 3; ++k) p += location.weights[k] * pose.col(rest.cells[location.cell][k]);
    return p;
}

std::vector<PinView> viewPins(const std::vector<Handle<2>>& handles, const std::vector<PinPlace>& places,
                              const SimplicialMesh<2>& rest, const Points<2>& pose, double time) {
    std::vector<PinView> views;
    for (std::size_t h = 0; h < std::min(handles.size(), places.size()); ++h) {
        if (!isActive(handles[h], time) || places[h].isEmpty()) continue;
        PinView view;
        view.handle = static_cast<int>(h);
        view.name = QString::fromStdString(handles[h].name);
        view.region = places[h].region;
        for (const auto& location : places[h].points) view.points.push_back(positionOf(location, rest, pose));
        view.centre = meanOf(view.points);
        views.push_back(std::move(view));
    }
    return views;
}

std::vector<Vec<2>> convexHull(std::vector<Vec<2>> points) {
    std::sort(points.begin(), points.end(), [](const Vec<2>& a, const Vec<2>& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    std::vector<Vec<2>> hull;
    const auto turnsLeft = [&hull](const Vec<2>& p) {
        const Vec<2> a = hull.back() - hull[hull.size() - 2], b = p - hull.back();
        return a.x() * b.y() - a.y() * b.x() > 0;
    };
    for (const bool upper : {false, true}) {  // the lower half from left to right, the upper one back
        const std::size_t first = hull.size();
        for (const Vec<2>& p : points) {
            while (hull.size() >= first + 2 && !turnsLeft(p)) hull.pop_back();
            hull.push_back(p);
        }
        if (!hull.empty()) hull.pop_back();  // the other half begins with it
        if (!upper) std::reverse(points.begin(), points.end());
    }
    return hull;
}

std::optional<Vec<2>> restPoint(const SimplicialMesh<2>& rest, const Points<2>& pose, const Vec<2>& p) {
    const PointLocator<2> locator(pose, rest.cells);
    const auto location = locator.find(p);
    if (!location) return {};
    return positionOf(*location, rest, rest.points);
}

std::vector<PinPath> pinPaths(const Handle<2>& handle, const std::vector<Vec<2>>& starts) {
    std::vector<PinPath> paths;
    for (const Vec<2>& start : starts) {
        PinPath path;
        path.points = {start};
        path.times = {handle.motions.empty() ? 0 : handle.motions.front().start};
        for (const Motion<2>& motion : handle.motions) appendMotion(motion, path);
        paths.push_back(std::move(path));
    }
    return paths;
}

}  // namespace wend
