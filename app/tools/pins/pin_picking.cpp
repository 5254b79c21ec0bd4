#include "app/tools/pins/pin_picking.h"

#include "app/engine/shape/mesh_parts.h"
#include "app/project/design.h"
#include "app/session/pins/pin_shapes.h"
#include "app/style/mark_size.h"
#include "app/tools/drawn_outline.h"
#include "app/tools/region_outline.h"

namespace wend {

namespace {

constexpr double kPinReach = 9;    // pixels of the screen
constexpr double kPointReach = 5;  // of single points of a handle of many
constexpr double kWayReach = 5;
constexpr double kGhostReach = 5;  // smaller for inactive handles, because a new pin may be intended
// fraction of the shape's size within which a visible point is the place itself
constexpr double kSamePlace = 1e-3;

}  // namespace

/// In the plane, covered means that another place of the rest shape is visible there.
template <>
bool isCovered<2>(ToolSurface& surface, const PinView<2>& pin, std::size_t point) {
    const auto frame = surface.session().frame<2>();
    if (!frame || point >= pin.places.size()) return false;
    const auto& rest = frame->rest->points;
    const auto seen =
        surface.touch(surface.toWidget(positionOf<2>(pin.places[point], *frame->rest, frame->pose)));
    return seen && (positionOf<2>(seen->place, *frame->rest, rest) -
                    positionOf<2>(pin.places[point], *frame->rest, rest))
                           .norm() > kSamePlace * frame->diagonal;
}

template <>
bool isCovered<3>(SolidSurface& surface, const PinView<3>& pin, std::size_t point) {
    return surface.isHidden(pin.points[point]);
}

/// The mark of an area is at no point of the shape.
template <int Dim>
bool isMarkCovered(SurfaceOf<Dim>& surface, const PinView<Dim>& pin) {
    if (!pin.region && pin.points.size() == 1) return isCovered<Dim>(surface, pin, 0);
    if constexpr (Dim == 3)
        return !pin.points.empty() &&
               std::ranges::all_of(pin.points, [&](const Vec<3>& p) { return surface.isCutOff(p); });
    return false;
}

template <int Dim>
int markUnder(SurfaceOf<Dim>& surface, const QPointF& widget, bool through) {
    const auto distance = [&](const PinView<Dim>& pin) {
        return QLineF(surface.toWidget(pin.centre), widget).length();
    };
    PinPick marks, ghosts;
    for (const PinView<Dim>& pin : surface.session().template pins<Dim>())
        if (const double d = distance(pin); d <= marked(kPinReach))
            marks.offer(pin.handle, d, !through && isMarkCovered<Dim>(surface, pin));
    if (marks.handle() >= 0) return marks.handle();
    for (const PinView<Dim>& ghost : surface.session().template ghosts<Dim>())
        if (const double d = distance(ghost); d <= marked(kGhostReach)) ghosts.offer(ghost.handle, d, false);
    return ghosts.handle();
}

namespace {

/// Returns the visible region under the pointer, the smallest of several.
int regionUnder(ToolSurface& surface, const QPointF& widget) {
    ShapeSession& session = surface.session();
    const auto frame = session.frame<2>();
    if (!frame) return -1;
    const auto seen = surface.touch(widget);
    PinPick pick;
    for (const PinView<2>& view : session.pins()) {
        if (!view.region) continue;
        const Pin& handle = session.document().design().handles[view.handle];
        const bool isBehind =  // another part, which is to be pinned itself
            seen && !handle.part.empty() && partNameOf<2>(*frame->rest, seen->place.cell) != handle.part;
        if (isBehind) continue;
        QPolygonF border;
        for (const Vec<2>& p : regionBorder(handle, view, *frame)) border << surface.toWidget(p);
        if (!border.containsPoint(widget, Qt::OddEvenFill)) continue;
        const QRectF box = border.boundingRect();
        const auto* region = std::get_if<Region<3>>(&handle.at);
        const bool covered = seen && region &&
                             signedDistance<2>(inPlane(*region), positionOf<2>(seen->place, *frame->rest,
                                                                               frame->rest->points)) > 0;
        pick.offer(view.handle, box.width() * box.height(), covered);
    }
    return pick.handle();
}

}  // namespace

template <int Dim>
int partUnder(SurfaceOf<Dim>& surface, const QPointF& widget, bool through) {
    PinPick pick;
    for (const PinView<Dim>& pin : surface.session().template pins<Dim>())
        for (std::size_t i = 0; i < pin.points.size() && !(Dim == 2 && pin.region); ++i)
            if (const double d = QLineF(surface.toWidget(pin.points[i]), widget).length();
                d <= marked(kPointReach) && (through || !isCovered<Dim>(surface, pin, i)))
                pick.offer(pin.handle, d, false);
    if constexpr (Dim == 2)
        if (pick.handle() < 0) return regionUnder(surface, widget);
    return pick.handle();
}

template <int Dim>
int wayUnder(SurfaceOf<Dim>& surface, const QPointF& widget) {
    ShapeSession& session = surface.session();
    int best = -1;
    double nearest = marked(kWayReach);
    const auto& handles = session.document().design().handles;
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

#define WEND_INSTANTIATE(Dim)                                               \
    template bool isMarkCovered<Dim>(SurfaceOf<Dim>&, const PinView<Dim>&); \
    template int markUnder<Dim>(SurfaceOf<Dim>&, const QPointF&, bool);     \
    template int partUnder<Dim>(SurfaceOf<Dim>&, const QPointF&, bool);     \
    template int wayUnder<Dim>(SurfaceOf<Dim>&, const QPointF&)

WEND_INSTANTIATE(2);
WEND_INSTANTIATE(3);
#undef WEND_INSTANTIATE

}  // namespace wend
