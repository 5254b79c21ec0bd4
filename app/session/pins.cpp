#include "app/session/pins.h"

#include <algorithm>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/pin_edits.h"
#include "app/session/shape_session.h"
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

std::vector<Vec2> convexHull(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::vector<Vec2> hull;
    const auto turnsLeft = [&hull](const Vec2& p) {
        const Vec2 a = hull.back() - hull[hull.size() - 2], b = p - hull.back();
        return a.x() * b.y() - a.y() * b.x() > 0;
    };
    for (const bool upper : {false, true}) {  // the lower half from left to right, the upper one back
        const std::size_t first = hull.size();
        for (const Vec2& p : points) {
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

/// Returns null if the document has another dimension.
FramePtr ShownPins::shape() const {
    const FramePtr frame = m_motion.frame();
    return frame && frame->dimension == m_document.dimension() ? frame : FramePtr();
}

const std::vector<PinPlace>& ShownPins::places() const {
    const FramePtr shape = this->shape();
    if (m_places.rest != shape->shape || m_places.project != m_document.project())
        m_places = {shape->shape, m_document.project(),
                    RestPlaces::of(*shape)->placesOf(m_document.design().handles)};
    return m_places.of;
}

int ShownPins::count() const {
    return static_cast<int>(m_document.design().handles.size());
}

bool ShownPins::isLocked(int handle) const {
    if (traitsOf(m_document.design(), handle).locked) return true;
    const auto& parts = m_document.domain().parts;
    if (std::ranges::none_of(parts, &PicturePart::locked)) return false;
    std::string name = m_document.design().handles.at(handle).part;
    const FramePtr shape = this->shape();
    if (name.empty() && shape && !places()[handle].isEmpty())
        name = shape->partOf(places()[handle].points.front().cell);
    const auto part = std::ranges::find(parts, name, &PicturePart::name);
    return part != parts.end() && part->locked;
}

QString ShownPins::nameOf(const std::vector<int>& handles) const {
    if (handles.size() != 1) return ShapeSession::tr("%n pins", nullptr, static_cast<int>(handles.size()));
    return QString::fromStdString(m_document.design().handles.at(handles[0]).name);
}

std::vector<PinView> ShownPins::at(double time, bool holding, bool all) const {
    const FramePtr shape = this->shape();
    if (!shape) return {};
    const auto& handles = m_document.design().handles;
    auto views = viewPins(handles, places(), *shape, time, holding);
    std::erase_if(views, [&](const auto& view) { return !all && handles[view.handle].traits.hidden; });
    return views;
}

std::vector<Vec3> ShownPins::pathStarts(int handle) const {
    std::vector<Vec3> starts;
    const FramePtr shape = this->shape();
    if (!shape) return starts;
    const double from = m_document.design().handles.at(handle).activeFrom;
    const FramePtr first = from > 0 ? m_motion.track().at(from) : FramePtr();
    const bool isMoved = first && first->shape == shape->shape;
    for (const Place& place : places()[handle].points)
        starts.push_back(isMoved ? first->at(place) : shape->restAt(place));
    return starts;
}

std::vector<int> ShownPins::verticesOf(int handle) const {
    const FramePtr shape = this->shape();
    std::vector<int> vertices;
    if (!shape) return vertices;
    for (const Place& place : places()[handle].points) {
        int corner = 0;
        place.weights.maxCoeff(&corner);
        vertices.push_back(shape->corners(place.cell)[corner]);
    }
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

Placement<3> ShownPins::placementOf(const std::vector<int>& vertices) const {
    const FramePtr shape = this->shape();
    if (!shape || m_document.domain().kind == DomainKind::Mesh) return vertices;
    std::vector<Vec3> points;
    points.reserve(vertices.size());
    for (const int v : vertices) points.push_back(shape->restVertex(v));
    return points;
}

}  // namespace wend
