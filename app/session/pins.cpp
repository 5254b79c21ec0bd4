#include "app/session/pins.h"

#include <algorithm>

#include "app/project/edits/handle_edits.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr int kPathSamples = 60;  // per motion

template <int Dim>
void appendMotion(const PinMotion& motion, PinPath& path) {
    const Trajectory<Dim> trajectory(motionIn<Dim>(motion));
    const Vec<Dim> from = path.points.back().template head<Dim>();
    for (int i = 0; i <= kPathSamples; ++i) {
        const double t = motion.start + (motion.end - motion.start) * i / kPathSamples;
        path.points.push_back(inSpace(trajectory.at(t).position(from)));
        path.times.push_back(t);
    }
}

}  // namespace

Vec3 meanOf(const std::vector<Vec3>& points) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

std::vector<PinView> viewPins(const std::vector<Pin>& handles, const std::vector<PinPlace>& places,
                              const ShapeFrame& frame, double time, bool holding) {
    std::vector<PinView> views;
    for (std::size_t h = 0; h < std::min(handles.size(), places.size()); ++h) {
        if (isActive(handles[h], time) != holding || places[h].isEmpty()) continue;
        PinView view;
        view.handle = static_cast<int>(h);
        view.name = QString::fromStdString(handles[h].name);
        view.region = places[h].region;
        for (const Place& place : places[h].points) view.points.push_back(frame.at(place));
        view.places = places[h].points;
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

std::vector<PinPath> pinPaths(const Pin& handle, const std::vector<Vec3>& starts, int dimension) {
    std::vector<PinPath> paths;
    for (const Vec3& start : starts) {
        PinPath path;
        path.points = {start};
        path.times = {handle.motions.empty() ? 0 : handle.motions.front().start};
        for (const PinMotion& motion : handle.motions)
            dimension == 2 ? appendMotion<2>(motion, path) : appendMotion<3>(motion, path);
        paths.push_back(std::move(path));
    }
    return paths;
}

}  // namespace wend
