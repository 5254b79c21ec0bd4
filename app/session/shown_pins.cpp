#include "app/session/shown_pins.h"

#include <algorithm>

#include "app/engine/shape/mesh_parts.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/pin_edits.h"
#include "app/session/shape_session.h"

namespace wend {

/// Returns null if the document has another dimension.
template <int Dim>
PosedPtr<Dim> ShownPins::shape() const {
    return m_document.dimension() == Dim ? posed<Dim>(m_motion.frame()) : PosedPtr<Dim>();
}

template <int Dim>
const std::vector<PinPlace<Dim>>& ShownPins::places() const {
    auto& hold = std::get<Hold<Dim>>(m_holds);
    const auto shape = this->shape<Dim>();
    if (hold.rest != shape->rest || hold.project != m_document.project()) {
        const PointLocator<Dim> locator(shape->rest->points, shape->rest->cells);
        hold.rest = shape->rest;
        hold.project = m_document.project();
        hold.places = placePins<Dim>(m_document.design().handles, *shape->rest, locator);
    }
    return hold.places;
}

int ShownPins::count() const {
    return static_cast<int>(m_document.design().handles.size());
}

bool ShownPins::isLocked(int handle) const {
    if (traitsOf(m_document.design(), handle).locked) return true;
    const auto& parts = m_document.domain().parts;
    if (std::ranges::none_of(parts, &PicturePart::locked)) return false;
    std::string name = m_document.design().handles.at(handle).part;
    const auto shape = this->shape<2>();
    if (name.empty() && shape && !places<2>()[handle].isEmpty())
        name = partNameOf<2>(*shape->rest, places<2>()[handle].points.front().cell);
    const auto part = std::ranges::find(parts, name, &PicturePart::name);
    return part != parts.end() && part->locked;
}

QString ShownPins::nameOf(const std::vector<int>& handles) const {
    if (handles.size() != 1) return ShapeSession::tr("%n pins", nullptr, static_cast<int>(handles.size()));
    return QString::fromStdString(m_document.design().handles.at(handles[0]).name);
}

template <int Dim>
std::vector<PinView<Dim>> ShownPins::at(double time, bool holding, bool all) const {
    const auto shape = this->shape<Dim>();
    if (!shape) return {};
    const auto& handles = m_document.design().handles;
    auto views = viewPins<Dim>(handles, places<Dim>(), *shape->rest, shape->pose, time, holding);
    std::erase_if(views, [&](const auto& view) { return !all && handles[view.handle].traits.hidden; });
    return views;
}

template <int Dim>
std::vector<Vec<Dim>> ShownPins::pathStarts(int handle) const {
    std::vector<Vec<Dim>> starts;
    const auto shape = this->shape<Dim>();
    if (!shape) return starts;
    const double from = m_document.design().handles.at(handle).activeFrom;
    const auto first = posed<Dim>(from > 0 ? m_motion.track().at(from) : FramePtr());
    const SimplicialMesh<Dim>& rest = *shape->rest;
    const Points<Dim>& pose = first && first->rest == shape->rest ? first->pose : rest.points;
    for (const auto& location : places<Dim>()[handle].points)
        starts.push_back(positionOf<Dim>(location, rest, pose));
    return starts;
}

std::vector<int> ShownPins::verticesOf(int handle) const {
    const auto shape = this->shape<3>();
    std::vector<int> vertices;
    if (!shape) return vertices;
    for (const auto& location : places<3>()[handle].points) {
        int corner = 0;
        location.weights.maxCoeff(&corner);
        vertices.push_back(shape->rest->cells[location.cell][corner]);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

Placement<3> ShownPins::placementOf(const std::vector<int>& vertices) const {
    const auto shape = this->shape<3>();
    if (!shape || m_document.domain().kind == DomainKind::Mesh) return vertices;
    std::vector<Vec<3>> points;
    points.reserve(vertices.size());
    for (const int v : vertices) points.push_back(shape->rest->points.col(v));
    return points;
}

#define WEND_INSTANTIATE(Dim)                                                        \
    template std::vector<PinView<Dim>> ShownPins::at<Dim>(double, bool, bool) const; \
    template std::vector<Vec<Dim>> ShownPins::pathStarts<Dim>(int) const

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
