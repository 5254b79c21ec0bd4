#include "app/session/pins/pin_shapes.h"

#include "app/document/design.h"
#include "app/document/edits/handle_edits.h"
#include "app/session/motion/pose_places.h"

namespace wend {

namespace {

template <int Dim>
constexpr int kMinHeld = Dim + 1;  // vertices: fewer do not hold a part in its place

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

}  // namespace

template <int Dim>
bool widenPin(ShapeSession& session, int handle, double radius, const QString& key) {
    const auto shape = session.frame<Dim>();
    if (!session.mayChange(handle)) return false;
    if (!shape || session.document().dimension() != Dim) return false;
    Document& document = session.document();
    const Handle<Dim>& own = document.design<Dim>().handles.at(handle);
    const Vec<Dim> middle = middleOf<Dim>(own.at, *shape->rest);
    if (radius == 0) {
        const Placement<Dim> point = std::vector<Vec<Dim>>{pointNear<Dim>(middle, *shape->rest)};
        document.changeDesign(ShapeSession::tr("Change %1").arg(QString::fromStdString(own.name)),
                              withHandlePlace<Dim>(document.design<Dim>(), handle, point), key);
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
                          withHandlePlace<Dim>(document.design<Dim>(), handle, wide), key);
    return true;
}

template bool widenPin<2>(ShapeSession&, int, double, const QString&);
template bool widenPin<3>(ShapeSession&, int, double, const QString&);

}  // namespace wend
