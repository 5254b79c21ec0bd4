#include "app/session/shown_pins.h"

#include <algorithm>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/pin_edits.h"
#include "app/session/shape_session.h"

namespace wend {

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
