#include "app/session/pin_shapes.h"

#include "app/document/design.h"
#include "app/document/handle_edits.h"
#include "app/session/solid_places.h"

namespace wend {

namespace {

constexpr int kMinHeld = 3;  // vertices: fewer do not hold a part in its place

Vec<2> meanOfVertices(const std::vector<int>& vertices, const SimplicialMesh<2>& rest) {
    std::vector<Vec<2>> points;
    for (const int v : vertices)
        if (v >= 0 && v < rest.vertexCount()) points.push_back(rest.points.col(v));
    return points.empty() ? Vec<2>(Vec<2>::Zero()) : meanOf<2>(points);
}

/// The middle of what a handle holds, at rest.
Vec<2> middleOf(const Placement<2>& at, const SimplicialMesh<2>& rest) {
    if (const auto* points = std::get_if<std::vector<Vec<2>>>(&at)) return meanOf<2>(*points);
    if (const auto* vertices = std::get_if<std::vector<int>>(&at)) return meanOfVertices(*vertices, rest);
    const auto& region = std::get<Region<2>>(at);
    if (const auto* circle = std::get_if<Ball<2>>(&region)) return circle->centre;
    return meanOfVertices(verticesInside<2>(region, rest), rest);
}

}  // namespace

bool widenPin(ShapeSession& session, int handle, double radius, const QString& key) {
    const auto shape = session.frame<2>();
    if (!session.mayChange(handle)) return false;
    if (!shape || session.document().dimension() != 2) return false;
    Document& document = session.document();
    const Handle<2>& own = document.design<2>().handles.at(handle);
    const Region<2> wide = Ball<2>{middleOf(own.at, *shape->rest), radius};
    if (static_cast<int>(verticesInside<2>(wide, *shape->rest).size()) < kMinHeld) {
        emit session.notice(
            ShapeSession::tr("This circle is smaller than the mesh: drag further, or set more vertices."));
        return false;
    }
    document.changeDesign(ShapeSession::tr("Widen %1").arg(QString::fromStdString(own.name)),
                          withHandlePlace<2>(document.design<2>(), handle, wide), key);
    return true;
}

}  // namespace wend
