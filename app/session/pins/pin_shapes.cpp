#include "app/session/pins/pin_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/project/design.h"
#include "app/project/edits/curve_edits.h"
#include "app/project/edits/handle_edits.h"
#include "app/session/shape_session.h"

namespace wend {

namespace {

constexpr double kNoTurn = 0.002;  // radians: less is not seen

/// Returns how many vertices hold a part in its place.
int leastHeld(const ShapeFrame& frame) {
    return frame.dimension + 1;
}

Vec3 meanOfVertices(const std::vector<int>& vertices, const ShapeFrame& frame) {
    std::vector<Vec3> points;
    for (const int v : vertices)
        if (v >= 0 && v < frame.vertices) points.push_back(frame.restVertex(v));
    return points.empty() ? Vec3(Vec3::Zero()) : meanOf(points);
}

/// Returns the centre of a handle's points at rest.
Vec3 middleOf(const Placement<3>& at, const ShapeFrame& frame) {
    if (const auto* points = std::get_if<std::vector<Vec3>>(&at)) return meanOf(*points);
    if (const auto* vertices = std::get_if<std::vector<int>>(&at)) return meanOfVertices(*vertices, frame);
    const auto& region = std::get<Region<3>>(at);
    if (const auto* ball = std::get_if<Ball<3>>(&region)) return ball->centre;
    return meanOfVertices(frame.verticesInside(region), frame);
}

/// Returns the single point that represents a handle: its centre, or the nearest vertex if that is in a hole.
Vec3 pointNear(const Vec3& middle, const ShapeFrame& frame) {
    if (RestPlaces::of(frame)->find(middle)) return middle;
    int nearest = 0;
    for (int v = 1; v < frame.vertices; ++v)
        if ((frame.restVertex(v) - middle).squaredNorm() < (frame.restVertex(nearest) - middle).squaredNorm())
            nearest = v;
    return frame.restVertex(nearest);
}

/// Returns the radius at which a disc or ball holds enough vertices of the part that the handle names, or of
/// all, to turn what is around.
double turningRadius(const Vec3& middle, const ShapeFrame& frame, const std::string& part) {
    const auto own = std::ranges::find(frame.parts(), part, &MeshPart::name);
    const MeshPart range =
        own != frame.parts().end() ? *own : MeshPart{"", 0, frame.vertices, 0, frame.cells};
    std::vector<bool> isUsed(static_cast<std::size_t>(frame.vertices), false);
    for (int c = range.firstCell; c < range.endCell; ++c)
        for (const int v : frame.corners(c)) isUsed[v] = true;
    std::vector<double> distances;
    for (int v = range.firstVertex; v < range.endVertex; ++v)
        if (isUsed[v]) distances.push_back((frame.restVertex(v) - middle).norm());
    const auto last = std::min<std::size_t>(2 * leastHeld(frame), distances.size()) - 1;
    std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(last),
                     distances.end());
    constexpr double kRoom = 1.01;  // so that the last one is safely inside
    return kRoom * distances[last];
}

/// Returns null if the document has another dimension.
FramePtr shapeOf(const ShapeSession& session) {
    const FramePtr frame = session.motion().frame();
    return frame && frame->dimension == session.document().dimension() ? frame : FramePtr();
}

/// Returns the single selected handle of a shown shape, or −1.
int singleShown(const ShapeSession& session) {
    return session.motion().frame() ? session.selection().single() : -1;
}

}  // namespace

bool holdsPoint(const ShapeSession& session, int handle) {
    if (handle < 0) return false;
    const Placement<3>& at = session.document().design().handles.at(handle).at;
    const auto* vertices = std::get_if<std::vector<int>>(&at);
    const auto* points = std::get_if<std::vector<Vec3>>(&at);
    return (vertices && vertices->size() == 1) || (points && points->size() == 1);
}

bool widenPoint(ShapeSession& session, int handle) {
    const FramePtr frame = shapeOf(session);
    if (!frame) return false;
    const Pin& own = session.document().design().handles.at(handle);
    return widenPin(session, handle, turningRadius(middleOf(own.at, *frame), *frame, own.part));
}

double angleAt(const ShapeSession& session, int handle) {
    const FramePtr frame = shapeOf(session);
    for (const PinView& pin : session.gestures().pins(true)) {
        if (!frame || pin.handle != handle || pin.places.empty()) continue;
        const Mat3 R = frame->rotationOf(pin.places.front().cell);
        return std::atan2(R(1, 0), R(0, 0));
    }
    return 0;
}

void setHoldsAngle(ShapeSession& session, int handle, bool holds) {
    if (!holds) {
        widenPin(session, handle, 0);
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
    for (const PinView& pin : session.gestures().pins(true))
        if (pin.handle == handle) grip.centre = pin.centre;
    if (!widenPoint(session, handle)) return false;
    if (std::abs(angle) > kNoTurn) session.gestures().moveAtOnce(grip, {angle, 0, 0});
    return true;
}

bool widenPin(ShapeSession& session, int handle, double radius, const QString& key) {
    const FramePtr frame = shapeOf(session);
    if (!session.gestures().mayChange(handle) || !frame) return false;
    Document& document = session.document();
    const Pin& own = document.design().handles.at(handle);
    const Vec3 middle = middleOf(own.at, *frame);
    if (radius == 0) {
        document.changeDesign(
            ShapeSession::tr("Change %1").arg(QString::fromStdString(own.name)),
            withHandlePlace(document.design(), handle, std::vector<Vec3>{pointNear(middle, *frame)}), key);
        return true;
    }
    const Region<3> wide = Ball<3>{middle, radius};
    if (static_cast<int>(frame->verticesInside(wide).size()) < leastHeld(*frame)) {
        session.document().notify(
            frame->dimension == 2
                ? ShapeSession::tr("This circle is smaller than the mesh: make it larger, or the mesh finer.")
                : ShapeSession::tr("This ball is smaller than the mesh: make it larger, or the mesh finer."));
        return false;
    }
    document.changeDesign(ShapeSession::tr("Widen %1").arg(QString::fromStdString(own.name)),
                          withHandlePlace(document.design(), handle, wide), key);
    return true;
}

bool canMakeCurve(const ShapeSession& session) {
    const int handle = singleShown(session);
    if (handle < 0) return false;
    return canBecomeCurve(session.document().design(), handle);
}

void makeCurve(ShapeSession& session) {
    if (!canMakeCurve(session)) return;
    Document& document = session.document();
    const int handle = singleShown(session);
    const auto starts = session.pins().pathStarts(handle);
    if (starts.empty()) return;
    const auto path = pinPaths(document.design().handles[handle], {meanOf(starts)}, document.dimension());
    const auto next = withCurve(document.design(), handle, path.front().points.back());
    if (next) document.changeDesign(ShapeSession::tr("Edit path"), *next);
}

}  // namespace wend
