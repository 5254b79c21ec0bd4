#include "app/tools/pins/pin_picking.h"

#include <algorithm>

#include "app/project/design.h"
#include "app/session/pins/pin_shapes.h"
#include "app/session/shape_session.h"
#include "app/style/marks.h"
#include "app/tools/drawn_outline.h"
#include "app/tools/region_outline.h"

namespace wend {

namespace {

constexpr double kPinReach = 9;    // pixels of the screen
constexpr double kPointReach = 5;  // of single points of a handle of many
constexpr double kWayReach = 5;
constexpr double kGhostReach = 5;  // smaller for inactive handles, because a new pin may be intended

}  // namespace

bool isCovered(const ShapeView& view, const PinView& pin, std::size_t point) {
    return point < pin.places.size() && view.isHidden(pin.places[point], pin.points[point]);
}

/// Returns whether the mark of a pin is hidden; that of an area is at no point of the shape.
bool isMarkCovered(const ShapeView& view, const PinView& pin) {
    if (!pin.region && pin.points.size() == 1) return isCovered(view, pin, 0);
    return !pin.points.empty() &&
           std::ranges::all_of(pin.points, [&](const Vec3& p) { return view.isCutOff(p); });
}

int markUnder(ShapeView& view, const QPointF& widget, bool through) {
    const auto distance = [&](const PinView& pin) {
        return QLineF(view.onScreen(pin.centre), widget).length();
    };
    PinPick marks, ghosts;
    for (const PinView& pin : view.session().gestures().pins())
        if (const double d = distance(pin); d <= marked(kPinReach))
            marks.offer(pin.handle, d, !through && isMarkCovered(view, pin));
    if (marks.handle() >= 0) return marks.handle();
    for (const PinView& ghost : view.session().gestures().ghosts())
        if (const double d = distance(ghost); d <= marked(kGhostReach)) ghosts.offer(ghost.handle, d, false);
    return ghosts.handle();
}

namespace {

/// Returns the visible region of a picture under the pointer, the smallest of several.
int regionUnder(ShapeView& view, const QPointF& widget) {
    const auto frame = view.session().motion().frame<2>();
    if (!frame) return -1;
    const auto seen = view.touch(widget);
    PinPick pick;
    for (const PinView& pin : view.session().gestures().pins()) {
        if (!pin.region) continue;
        const Pin& handle = view.session().document().design().handles[pin.handle];
        const bool isBehind =  // another part, which is to be pinned itself
            seen && !handle.part.empty() && frame->partOf(seen->place.cell) != handle.part;
        if (isBehind) continue;
        QPolygonF border;
        for (const Vec3& p : regionBorder(handle, pin, *frame)) border << view.onScreen(p);
        if (!border.containsPoint(widget, Qt::OddEvenFill)) continue;
        const QRectF box = border.boundingRect();
        const auto* region = std::get_if<Region<3>>(&handle.at);
        const bool covered =
            seen && region && signedDistance<2>(inPlane(*region), inPlane(frame->restAt(seen->place))) > 0;
        pick.offer(pin.handle, box.width() * box.height(), covered);
    }
    return pick.handle();
}

}  // namespace

int partUnder(ShapeView& view, const QPointF& widget, bool through) {
    const bool isFlat = view.dimension() == 2;
    PinPick pick;
    for (const PinView& pin : view.session().gestures().pins())
        for (std::size_t i = 0; i < pin.points.size() && !(isFlat && pin.region); ++i)
            if (const double d = QLineF(view.onScreen(pin.points[i]), widget).length();
                d <= marked(kPointReach) && (through || !isCovered(view, pin, i)))
                pick.offer(pin.handle, d, false);
    return isFlat && pick.handle() < 0 ? regionUnder(view, widget) : pick.handle();
}

int wayUnder(ShapeView& view, const QPointF& widget) {
    int best = -1;
    double nearest = marked(kWayReach);
    const auto& handles = view.session().document().design().handles;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        if (handles[h].motions.empty() || handles[h].activeTo <= view.session().playback().time() ||
            handles[h].traits.hidden)
            continue;
        for (const auto& way :
             pinPaths(handles[h], shownStarts(view.session().pins().pathStarts(h)), view.dimension()))
            for (std::size_t i = 1; i < way.points.size(); ++i) {
                const double d =
                    distanceToLine(widget, view.onScreen(way.points[i - 1]), view.onScreen(way.points[i]));
                if (d < nearest) nearest = d, best = h;
            }
    }
    return best;
}

}  // namespace wend
