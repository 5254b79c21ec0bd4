#include "app/session/pins/pin_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/engine/motion/pose_places.h"
#include "app/project/design.h"
#include "app/project/edits/handle_edits.h"
#include "core/mesh/used_vertices.h"

namespace wend {

namespace {

template <int Dim>
constexpr int kMinHeld = Dim + 1;  // vertices: fewer do not hold a part in its place
template <int Dim>
constexpr int kTurnHeld =
    2 * kMinHeld<Dim>;             // vertices of the smallest disc or ball that turns what is around
constexpr double kNoTurn = 0.002;  // radians: less is not seen

template <int Dim>
Vec<Dim> meanOfVertices(const std::vector<int>& vertices, const SimplicialMesh<Dim>& rest) {
    std::vector<Vec<Dim>> points;
    for (const int v : vertices)
        if (v >= 0 && v < rest.vertexCount()) points.push_back(rest.points.col(v));
    return points.empty() ? Vec<Dim>(Vec<Dim>::Zero()) : meanOf<Dim>(points);
}

/// Returns the centre of a handle's points at rest.
template <int Dim>
Vec<Dim> middleOf(const Placement<Dim>& at, const SimplicialMesh<Dim>& rest) {
    if (const auto* points = std::get_if<std::vector<Vec<Dim>>>(&at)) return meanOf<Dim>(*points);
    if (const auto* vertices = std::get_if<std::vector<int>>(&at)) return meanOfVertices(*vertices, rest);
    const auto& region = std::get<Region<Dim>>(at);
    if (const auto* ball = std::get_if<Ball<Dim>>(&region)) return ball->centre;
    return meanOfVertices(verticesInside<Dim>(region, rest), rest);
}

/// Returns the single point that represents a handle: its centre, or the nearest vertex if that is in a hole.
template <int Dim>
Vec<Dim> pointNear(const Vec<Dim>& middle, const SimplicialMesh<Dim>& rest) {
    if (PointLocator<Dim>(rest.points, rest.cells).find(middle, 1e-9)) return middle;
    Eigen::Index nearest = 0;
    (rest.points.colwise() - middle).colwise().squaredNorm().minCoeff(&nearest);
    return rest.points.col(nearest);
}

/// Returns the vertices and cells of the part that the handle names, or of all.
template <int Dim>
MeshPart rangeOf(const SimplicialMesh<Dim>& rest, const std::string& part) {
    const auto found = std::ranges::find(rest.parts, part, &MeshPart::name);
    return found != rest.parts.end() ? *found : MeshPart{"", 0, rest.vertexCount(), 0, rest.cellCount()};
}

/// Returns the radius at which a disc or ball holds enough of the part's vertices to turn it.
template <int Dim>
double turningRadius(const Vec<Dim>& middle, const SimplicialMesh<Dim>& rest, const MeshPart& part) {
    const std::vector<bool> used = usedVertices<Dim>(rest.vertexCount(), rest.cells);
    std::vector<double> distances;
    for (int v = part.firstVertex; v < part.endVertex; ++v)
        if (used[v]) distances.push_back((rest.points.col(v) - middle).norm());
    const auto last = std::min<std::size_t>(kTurnHeld<Dim>, distances.size()) - 1;
    std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(last),
                     distances.end());
    constexpr double kRoom = 1.01;  // so that the last one is safely inside
    return kRoom * distances[last];
}

}  // namespace

template <int Dim>
bool holdsPoint(const ShapeSession& session, int handle) {
    if (handle < 0 || session.document().dimension() != Dim) return false;
    const Placement<3>& at = session.document().design().handles.at(handle).at;
    const auto* vertices = std::get_if<std::vector<int>>(&at);
    const auto* points = std::get_if<std::vector<Vec3>>(&at);
    return (vertices && vertices->size() == 1) || (points && points->size() == 1);
}

template <int Dim>
bool widenPoint(ShapeSession& session, int handle) {
    const auto shape = session.frame<Dim>();
    if (!shape || session.document().dimension() != Dim) return false;
    const Pin& own = session.document().design().handles.at(handle);
    const Vec<Dim> middle = middleOf<Dim>(placementIn<Dim>(own.at), *shape->rest);
    return widenPin<Dim>(session, handle,
                         turningRadius<Dim>(middle, *shape->rest, rangeOf(*shape->rest, own.part)));
}

double angleAt(const ShapeSession& session, int handle) {
    const auto shape = session.frame<2>();
    for (const PinView<2>& pin : session.pins<2>(true)) {
        if (!shape || pin.handle != handle || pin.places.empty()) continue;
        const Mat<2> R = cellRotation<2>(*shape, pin.places.front().cell);
        return std::atan2(R(1, 0), R(0, 0));
    }
    return 0;
}

void setHoldsAngle(ShapeSession& session, int handle, bool holds) {
    if (!holds) {
        widenPin<2>(session, handle, 0);
        return;
    }
    session.document().beginStep();
    widenTurned(session, handle);
    session.document().endStep();
}

bool widenTurned(ShapeSession& session, int handle) {
    const double angle = angleAt(session, handle);
    Grip grip;
    grip.kind = Grip::Kind::Turn;
    for (const PinView<2>& pin : session.pins<2>(true))
        if (pin.handle == handle) grip.centre.head<2>() = pin.centre;
    if (!widenPoint<2>(session, handle)) return false;
    if (std::abs(angle) > kNoTurn) session.moveSelected<2>(grip, {angle, 0, 0});
    return true;
}

template <int Dim>
bool widenPin(ShapeSession& session, int handle, double radius, const QString& key) {
    const auto shape = session.frame<Dim>();
    if (!session.mayChange(handle)) return false;
    if (!shape || session.document().dimension() != Dim) return false;
    Document& document = session.document();
    const Pin& own = document.design().handles.at(handle);
    const Vec<Dim> middle = middleOf<Dim>(placementIn<Dim>(own.at), *shape->rest);
    if (radius == 0) {
        const Placement<Dim> point = std::vector<Vec<Dim>>{pointNear<Dim>(middle, *shape->rest)};
        document.changeDesign(ShapeSession::tr("Change %1").arg(QString::fromStdString(own.name)),
                              withHandlePlace(document.design(), handle, inSpace(point)), key);
        return true;
    }
    const Region<Dim> wide = Ball<Dim>{middle, radius};
    if (static_cast<int>(verticesInside<Dim>(wide, *shape->rest).size()) < kMinHeld<Dim>) {
        session.notify(
            Dim == 2
                ? ShapeSession::tr("This circle is smaller than the mesh: make it larger, or the mesh finer.")
                : ShapeSession::tr("This ball is smaller than the mesh: make it larger, or the mesh finer."));
        return false;
    }
    document.changeDesign(ShapeSession::tr("Widen %1").arg(QString::fromStdString(own.name)),
                          withHandlePlace(document.design(), handle, inSpace(wide)), key);
    return true;
}

#define WEND_INSTANTIATE(Dim)                                \
    template bool holdsPoint<Dim>(const ShapeSession&, int); \
    template bool widenPoint<Dim>(ShapeSession&, int);       \
    template bool widenPin<Dim>(ShapeSession&, int, double, const QString&)
WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
