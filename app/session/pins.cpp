#include "app/session/pins.h"

#include <algorithm>

#include "app/project/edits/handle_edits.h"
#include "core/mesh/region.h"
#include "core/motion/trajectory.h"

namespace wend {

namespace {

constexpr int kPathSamples = 60;  // per motion

/// Returns every vertex as a location: a corner of the first cell that has it.
template <int Dim>
std::vector<Location<Dim>> vertexLocations(const SimplicialMesh<Dim>& rest) {
    std::vector<Location<Dim>> all(rest.vertexCount());
    for (int c = 0; c < rest.cellCount(); ++c)
        for (int k = 0; k <= Dim; ++k) {
            Location<Dim>& location = all[rest.cells[c][k]];
            if (location.cell >= 0) continue;
            location.cell = c;
            location.weights.setZero();
            location.weights[k] = 1;
        }
    return all;
}

template <int Dim>
class Placer {
  public:
    Placer(const SimplicialMesh<Dim>& rest, const PointLocator<Dim>& locator)
        : m_rest(rest), m_locator(locator), m_vertices(vertexLocations(rest)) {}

    /// Returns the places of the handle's points, by the parts of HandlePlacer.
    PinPlace<Dim> place(const Pin& handle) {
        m_parts.clear();
        for (auto part = m_rest.parts.rbegin(); part != m_rest.parts.rend(); ++part)
            if (handle.part.empty() || handle.part == part->name) m_parts.push_back(*part);
        if (m_parts.empty()) m_parts.push_back({"", 0, m_rest.vertexCount(), 0, m_rest.cellCount()});
        m_isNamed = !handle.part.empty() && m_parts.size() == 1;
        return std::visit(*this, placementIn<Dim>(handle.at));
    }

    PinPlace<Dim> operator()(const std::vector<int>& vertices) const {
        PinPlace<Dim> place;
        const int first = m_isNamed ? m_parts.front().firstVertex : 0;
        for (const int v : vertices)
            if (v >= 0 && first + v < m_rest.vertexCount()) place.points.push_back(m_vertices[first + v]);
        return place;
    }
    /// The locator finds the frontmost part at a place.
    PinPlace<Dim> operator()(const std::vector<Vec<Dim>>& points) const {
        PinPlace<Dim> place;
        if (m_isNamed) return inPart(points, m_parts.front());
        for (const Vec<Dim>& p : points)
            if (const auto location = m_locator.find(p, 1e-9)) place.points.push_back(*location);
        return place;
    }
    PinPlace<Dim> operator()(const Region<Dim>& region) const {
        PinPlace<Dim> place;
        place.region = true;
        for (std::size_t i = 0; i < m_parts.size() && place.points.empty(); ++i)
            for (int v = m_parts[i].firstVertex; v < m_parts[i].endVertex; ++v)
                if (signedDistance<Dim>(region, m_rest.points.col(v)) <= 0)
                    place.points.push_back(m_vertices[v]);
        return place;
    }

  private:
    PinPlace<Dim> inPart(const std::vector<Vec<Dim>>& points, const MeshPart& part) const {
        PinPlace<Dim> place;
        const std::vector<Cell<Dim>> cells(m_rest.cells.begin() + part.firstCell,
                                           m_rest.cells.begin() + part.endCell);
        const PointLocator<Dim> locator(m_rest.points, cells);
        for (const Vec<Dim>& p : points)
            if (auto location = locator.find(p, 1e-9)) {
                location->cell += part.firstCell;
                place.points.push_back(*location);
            }
        return place;
    }

    const SimplicialMesh<Dim>& m_rest;
    const PointLocator<Dim>& m_locator;
    std::vector<Location<Dim>> m_vertices;
    std::vector<MeshPart> m_parts;  // that a handle may be in, from front to back
    bool m_isNamed = false;
};

template <int Dim>
void appendMotion(const PinMotion& motion, PinPath<Dim>& path) {
    const Trajectory<Dim> trajectory(motionIn<Dim>(motion));
    const Vec<Dim> from = path.points.back();
    for (int i = 0; i <= kPathSamples; ++i) {
        const double t = motion.start + (motion.end - motion.start) * i / kPathSamples;
        path.points.push_back(trajectory.at(t).position(from));
        path.times.push_back(t);
    }
}

}  // namespace

template <int Dim>
Vec<Dim> meanOf(const std::vector<Vec<Dim>>& points) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const Vec<Dim>& p : points) sum += p;
    return sum / static_cast<double>(points.size());
}

template <int Dim>
std::vector<PinPlace<Dim>> placePins(const std::vector<Pin>& handles, const SimplicialMesh<Dim>& rest,
                                     const PointLocator<Dim>& locator) {
    Placer<Dim> placer(rest, locator);
    std::vector<PinPlace<Dim>> places;
    places.reserve(handles.size());
    for (const Pin& handle : handles) places.push_back(placer.place(handle));
    return places;
}

template <int Dim>
Vec<Dim> positionOf(const Location<Dim>& location, const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    Vec<Dim> p = Vec<Dim>::Zero();
    for (int k = 0; k <= Dim; ++k) p += location.weights[k] * pose.col(rest.cells[location.cell][k]);
    return p;
}

template <int Dim>
std::vector<PinView<Dim>> viewPins(const std::vector<Pin>& handles, const std::vector<PinPlace<Dim>>& places,
                                   const SimplicialMesh<Dim>& rest, const Points<Dim>& pose, double time,
                                   bool holding) {
    std::vector<PinView<Dim>> views;
    for (std::size_t h = 0; h < std::min(handles.size(), places.size()); ++h) {
        if (isActive(handles[h], time) != holding || places[h].isEmpty()) continue;
        PinView<Dim> view;
        view.handle = static_cast<int>(h);
        view.name = QString::fromStdString(handles[h].name);
        view.region = places[h].region;
        for (const auto& location : places[h].points)
            view.points.push_back(positionOf<Dim>(location, rest, pose));
        view.places = places[h].points;
        view.centre = meanOf<Dim>(view.points);
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

template <int Dim>
std::vector<PinPath<Dim>> pinPaths(const Pin& handle, const std::vector<Vec<Dim>>& starts) {
    std::vector<PinPath<Dim>> paths;
    for (const Vec<Dim>& start : starts) {
        PinPath<Dim> path;
        path.points = {start};
        path.times = {handle.motions.empty() ? 0 : handle.motions.front().start};
        for (const PinMotion& motion : handle.motions) appendMotion(motion, path);
        paths.push_back(std::move(path));
    }
    return paths;
}

#define WEND_INSTANTIATE(Dim)                                                                                \
    template std::vector<PinPlace<Dim>> placePins<Dim>(const std::vector<Pin>&, const SimplicialMesh<Dim>&,  \
                                                       const PointLocator<Dim>&);                            \
    template Vec<Dim> positionOf<Dim>(const Location<Dim>&, const SimplicialMesh<Dim>&, const Points<Dim>&); \
    template std::vector<PinView<Dim>> viewPins<Dim>(                                                        \
        const std::vector<Pin>&, const std::vector<PinPlace<Dim>>&, const SimplicialMesh<Dim>&,              \
        const Points<Dim>&, double, bool);                                                                   \
    template Vec<Dim> meanOf<Dim>(const std::vector<Vec<Dim>>&);                                             \
    template std::vector<PinPath<Dim>> pinPaths<Dim>(const Pin&, const std::vector<Vec<Dim>>&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
