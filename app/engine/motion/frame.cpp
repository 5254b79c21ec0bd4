#include "app/engine/motion/frame.h"

#include <algorithm>

#include "app/engine/motion/places.h"
#include "app/engine/shape/mesh_parts.h"
#include "app/engine/shape/shape.h"

namespace wend {

namespace {

template <int Dim>
Vec3 carriedTo(const Points<Dim>& to, const Points<Dim>& from, const SimplicialMesh<Dim>& mesh,
               const std::string& part, const Vec3& p) {
    const auto own = std::ranges::find(mesh.parts, part, &MeshPart::name);
    const int first = own == mesh.parts.end() ? 0 : own->firstCell,
              end = own == mesh.parts.end() ? mesh.cellCount() : own->endCell;
    const std::vector<Cell<Dim>> cells(mesh.cells.begin() + first, mesh.cells.begin() + end);
    const PointLocator<Dim> locator(from, cells);
    const Vec<Dim> place = p.head<Dim>();
    if (auto found = locator.find(place)) {
        found->cell += first;
        return inSpace(positionOf<Dim>(*found, mesh, to));
    }
    const int nearest = locator.nearestVertex(place);
    return nearest < 0 ? p : inSpace(Vec<Dim>(to.col(nearest) + place - from.col(nearest)));
}

}  // namespace

Vec3 ShapeFrame::at(const Place& place) const {
    Vec3 p = Vec3::Zero();
    int k = 0;
    for (const int v : corners(place.cell)) p += place.weights[k++] * vertex(v);
    return p;
}

Vec3 ShapeFrame::restAt(const Place& place) const {
    Vec3 p = Vec3::Zero();
    int k = 0;
    for (const int v : corners(place.cell)) p += place.weights[k++] * restVertex(v);
    return p;
}

Vec3 ShapeFrame::centreOf(int cell) const {
    Vec3 centre = Vec3::Zero();
    for (const int v : corners(cell)) centre += vertex(v) / (dimension + 1);
    return centre;
}

Vec3 ShapeFrame::middle() const {
    Vec3 low = vertex(0), high = low;
    for (int v = 1; v < vertices; ++v) {
        low = low.cwiseMin(vertex(v));
        high = high.cwiseMax(vertex(v));
    }
    return (low + high) / 2;
}

std::string ShapeFrame::partOf(int cell) const {
    return partNameOf(parts(), cell);
}

template <int Dim>
bool PosedFrame<Dim>::hidesVertices() const {
    return built->hidesVertices();
}

template <int Dim>
std::optional<Place> PosedFrame<Dim>::find(const Vec3& p) const {
    const auto found = PointLocator<Dim>(pose, rest->cells).find(p.head<Dim>());
    return found ? std::optional(inSpace(*found)) : std::nullopt;
}

template <int Dim>
Place PosedFrame<Dim>::placeIn(int cell, const Vec3& p) const {
    return inSpace(locationIn<Dim>(*this, cell, p.head<Dim>()));
}

template <int Dim>
Mat3 PosedFrame<Dim>::rotationOf(int cell) const {
    Mat3 R = Mat3::Identity();
    R.topLeftCorner<Dim, Dim>() = cellRotation<Dim>(*this, cell);
    return R;
}

template <int Dim>
Vec3 PosedFrame<Dim>::carriedFromRest(const Vec3& p, const std::string& part) const {
    return carriedTo<Dim>(pose, rest->points, *rest, part, p);
}

template <int Dim>
Vec3 PosedFrame<Dim>::carriedToRest(const Vec3& p, const std::string& part) const {
    return carriedTo<Dim>(rest->points, pose, *rest, part, p);
}

template <int Dim>
std::vector<int> PosedFrame<Dim>::verticesInside(const Region<3>& region) const {
    return wend::verticesInside<Dim>(regionIn<Dim>(region), *rest);
}

template struct PosedFrame<2>;
template struct PosedFrame<3>;

namespace {

/// Returns a copy of the frame, changed by a function.
template <class Change>
FramePtr changedCopy(const FramePtr& frame, const Change& change) {
    const auto copy = [&](const auto& own) -> FramePtr {
        auto other = std::make_shared<std::decay_t<decltype(own)>>(own);
        change(*other);
        return other;
    };
    return frame->dimension == 2 ? copy(*posed<2>(frame)) : copy(*posed<3>(frame));
}

}  // namespace

FramePtr atTime(const FramePtr& frame, double time) {
    return changedCopy(frame, [time](auto& other) { other.time = time; });
}

FramePtr atRest(const FramePtr& frame) {
    return changedCopy(frame, [](auto& other) { other.pose = other.rest->points; });
}

}  // namespace wend
