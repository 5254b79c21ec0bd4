#include "app/tools/pin_picking.h"

#include <algorithm>

#include "app/document/design.h"
#include "app/session/mark_size.h"
#include "app/session/pin_shapes.h"

namespace wend {

namespace {

constexpr double kWayReach = 5;    // pixels of the screen
constexpr double kGhostReach = 5;  // of handles that do not hold now: a new pin may be wanted there
constexpr double kSame = 1e-3;     // of the shape's size: what is seen there is the place itself

double distanceToLine(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF along = b - a;
    const double size = QPointF::dotProduct(along, along);
    const double t = size > 0 ? QPointF::dotProduct(p - a, along) / size : 0;
    return QLineF(p, a + std::clamp(t, 0.0, 1.0) * along).length();
}

}  // namespace

/// In the plane what is seen there is another place of the shape at rest.
template <>
bool isCovered<2>(ToolSurface& surface, const PinView<2>& pin, std::size_t point) {
    const auto frame = surface.session().frame<2>();
    if (!frame || point >= pin.places.size()) return false;
    const auto& rest = frame->rest->points;
    const auto seen =
        surface.touch(surface.toWidget(positionOf<2>(pin.places[point], *frame->rest, frame->pose)));
    return seen && (positionOf<2>(seen->place, *frame->rest, rest) -
                    positionOf<2>(pin.places[point], *frame->rest, rest))
                           .norm() > kSame * frame->diagonal;
}

template <>
bool isCovered<3>(SolidSurface& surface, const PinView<3>& pin, std::size_t point) {
    return surface.isHidden(pin.points[point]);
}

template <int Dim>
int ghostUnder(SurfaceOf<Dim>& surface, const QPointF& widget) {
    PinPick pick;
    for (const PinView<Dim>& ghost : surface.session().template ghosts<Dim>())
        if (const double d = QLineF(surface.toWidget(ghost.centre), widget).length();
            d <= marked(kGhostReach))
            pick.offer(ghost.handle, d, false);
    return pick.handle();
}

template <int Dim>
int wayUnder(SurfaceOf<Dim>& surface, const QPointF& widget) {
    ShapeSession& session = surface.session();
    int best = -1;
    double nearest = marked(kWayReach);
    const auto& handles = session.document().template design<Dim>().handles;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        if (handles[h].motions.empty() || handles[h].activeTo <= session.playback().time() ||
            handles[h].traits.hidden)
            continue;
        for (const auto& way : pinPaths<Dim>(handles[h], shownStarts<Dim>(session.pathStarts<Dim>(h))))
            for (std::size_t i = 1; i < way.points.size(); ++i) {
                const double d = distanceToLine(widget, surface.toWidget(way.points[i - 1]),
                                                surface.toWidget(way.points[i]));
                if (d < nearest) nearest = d, best = h;
            }
    }
    return best;
}

template int ghostUnder<2>(ToolSurface&, const QPointF&);
template int ghostUnder<3>(SolidSurface&, const QPointF&);
template int wayUnder<2>(ToolSurface&, const QPointF&);
template int wayUnder<3>(SolidSurface&, const QPointF&);

}  // namespace wend
