#include "app/session/pins/mirroring.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <set>

#include "app/project/design.h"
#include "app/session/shape_session.h"

namespace wend {

namespace {

void mirrorAll(std::vector<Vec3>& points, const Mirror& mirror) {
    for (Vec3& p : points) p = mirror(p);
}

void change(Translate<3>& move, const Mirror& mirror) {
    move.by = mirror.along(move.by);
}
/// Mirrors an axis of rotation: a = −S a for the reflection S. One that stays in place keeps its direction,
/// as in pictures, where rotations are about +z.
void change(Rotate<3>& rotate, const Mirror& mirror) {
    rotate.centre = mirror(rotate.centre);
    const Vec3 axis = mirror.along(rotate.axis);
    if (axis == rotate.axis)
        rotate.angle = -rotate.angle;
    else
        rotate.axis = -axis;
}
void change(CurveMotion<3>& curve, const Mirror& mirror) {
    mirrorAll(curve.points, mirror);
    curve.twist = -curve.twist;
}
void change(Recorded<3>& stroke, const Mirror& mirror) {
    mirrorAll(stroke.points, mirror);
}

/// Mirrors the displacements, not the vertices. They differ from those of the file, which is named no more.
void change(FieldMotion<3>& motion, const Mirror& mirror) {
    auto values = std::make_shared<Displacements<3>>(*motion.values);
    for (auto& [vertex, displacement] : *values) displacement = mirror.along(displacement);
    motion = {"", "", std::move(values)};
}
/// Mirrors the poses. With the reflection S, a rotation R becomes S R S, whose rotation vector is −S w.
void change(PoseMotion<3>& motion, const Mirror& mirror) {
    motion.file.clear();
    for (RigidPose<3>& pose : motion.poses) {
        pose.position = mirror(pose.position);
        pose.rotation = -mirror.along(pose.rotation);
    }
}

void change(Polygon& polygon, const Mirror& mirror) {
    for (Vec2& p : polygon.points) p = inPlane(mirror(inSpace(p)));
}
void change(Ball<3>& ball, const Mirror& mirror) {
    ball.centre = mirror(ball.centre);
}
void change(Box<3>& box, const Mirror& mirror) {
    const Vec3 a = mirror(box.min), b = mirror(box.max);
    box = {a.cwiseMin(b), a.cwiseMax(b)};
}
void change(HalfSpace<3>& half, const Mirror& mirror) {
    half = {mirror(half.point), mirror.along(half.normal)};
}
void change(Blend<3>& blend, const Mirror& mirror) {
    blend = {mirror(blend.from), mirror(blend.to)};
}

constexpr double kReach = 0.02;  // fraction of the shape's size that an image may be off the shape
constexpr double kSame = 1e-3;   // of the shape's size: closer pins are one
constexpr int kSamples = 500;    // of the vertices
constexpr double kPaired =
    0.1;  // of the shape's size: a pin that is nearer to the image of another is its counterpart

/// Returns the mean length of an edge, using one of each cell.
double edgeOf(const ShapeFrame& frame) {
    double sum = 0;
    for (int c = 0; c < frame.cells; ++c) {
        const auto corners = frame.corners(c);
        sum += (frame.restVertex(corners[1]) - frame.restVertex(corners[0])).norm();
    }
    return sum / frame.cells;
}

/// Returns the mean distance of mirrored vertices from their nearest vertices; values below an edge length
/// are noise.
double unlikeness(const ShapeFrame& frame, const RestPlaces& places, const Mirror& mirror) {
    const int step = std::max(1, frame.vertices / kSamples);
    double sum = 0;
    int count = 0;
    for (int v = 0; v < frame.vertices; v += step, ++count) {
        const Vec3 image = mirror(frame.restVertex(v));
        sum += (frame.restVertex(places.nearestVertex(image)) - image).norm();
    }
    return std::max(sum / count, edgeOf(frame));
}

Mirror mirrorOf(const ShapeFrame& frame, const RestPlaces& places) {
    Vec3 low = frame.restVertex(0), high = low;
    for (int v = 1; v < frame.vertices; ++v) {
        low = low.cwiseMin(frame.restVertex(v));
        high = high.cwiseMax(frame.restVertex(v));
    }
    const Vec3 middle = (low + high) / 2;
    Mirror best{0, middle[0]};
    if (frame.dimension == 2) return best;
    double least = unlikeness(frame, places, best);
    for (int k = 1; k < 3; ++k) {
        const Mirror other{k, middle[k]};
        const double unlike = unlikeness(frame, places, other);
        if (unlike < least) least = unlike, best = other;
    }
    return best;
}

/// Makes mirror images of handles in a rest shape.
class Imager {
  public:
    explicit Imager(const ShapeFrame& frame)
        : m_frame(frame), m_places(RestPlaces::of(frame)), m_mirror(mirrorOf(frame, *m_places)) {}

    /// Returns nothing if the image would be outside the shape.
    std::optional<Pin> operator()(const Pin& handle) const {
        Pin image = handle;
        image.id = newId();
        if (!std::visit([this](auto& at) { return this->move(at); }, image.at)) return {};
        for (PinMotion& motion : image.motions) motion = mirrored(motion, m_mirror);
        if (image.normal) image.normal = m_mirror.along(*image.normal);
        image.traits.locked = image.traits.hidden = false;
        image.traits.link = 0;
        image.traits.colour.reset();
        return image;
    }
    /// Returns whether a handle already holds the same place.
    bool isTaken(const Pin& image, const std::vector<Pin>& handles) const {
        const Vec3 own = middleOf(image);
        return std::ranges::any_of(handles, [&](const Pin& other) {
            return (middleOf(other) - own).norm() < kSame * m_frame.diagonal;
        });
    }

    /// Returns the number of the handle that is nearest to the image of one.
    int counterpart(const std::vector<Pin>& handles, int of) const {
        const Vec3 image = m_mirror(middleOf(handles[of]));
        int best = of;
        double least = kPaired * m_frame.diagonal;
        for (int h = 0; h < static_cast<int>(handles.size()); ++h)
            if (const double off = (middleOf(handles[h]) - image).norm(); off < least) least = off, best = h;
        return best;
    }

  private:
    int nearest(const Vec3& p) const {
        const int v = m_places->nearestVertex(p);
        return (m_frame.restVertex(v) - p).norm() <= kReach * m_frame.diagonal ? v : -1;
    }
    bool move(std::vector<int>& vertices) const {
        std::set<int> images;
        for (const int v : vertices)
            if (v < m_frame.vertices) images.insert(nearest(m_mirror(m_frame.restVertex(v))));
        images.erase(-1);
        vertices.assign(images.begin(), images.end());
        return !vertices.empty();
    }
    bool move(std::vector<Vec3>& points) const {
        std::vector<Vec3> images;
        for (const Vec3& p : points) {
            const Vec3 image = m_mirror(p);
            if (m_places->find(image))
                images.push_back(image);
            else if (const int v = nearest(image); v >= 0)
                images.push_back(m_frame.restVertex(v));
        }
        points = images;
        return !points.empty();
    }
    bool move(Region<3>& region) const {
        region = mirrored(region, m_mirror);
        return !m_frame.verticesInside(region).empty();
    }
    Vec3 middleOf(const Pin& handle) const {
        std::vector<Vec3> points;
        for (const Place& place : m_places->placeOf(handle).points) points.push_back(m_frame.restAt(place));
        return points.empty() ? Vec3(Vec3::Constant(std::numeric_limits<double>::infinity()))
                              : meanOf(points);
    }

    const ShapeFrame& m_frame;
    std::unique_ptr<const RestPlaces> m_places;
    Mirror m_mirror;
};

QString imageName(const std::string& name) {
    return ShapeSession::tr("%1 mirrored").arg(QString::fromStdString(name));
}

std::string freeImageName(const std::vector<Pin>& handles, const std::string& name) {
    const QString wish = imageName(name);
    QString free = wish;
    const auto isTaken = [&](const QString& one) {
        return std::any_of(handles.begin(), handles.end(),
                           [&](const auto& h) { return h.name == one.toStdString(); });
    };
    for (int i = 2; isTaken(free); ++i) free = wish + QStringLiteral(" %1").arg(i);
    return free.toStdString();
}

}  // namespace

Vec3 Mirror::operator()(Vec3 p) const {
    p[axis] = 2 * at - p[axis];
    return p;
}

Vec3 Mirror::along(Vec3 direction) const {
    direction[axis] = -direction[axis];
    return direction;
}

PinMotion mirrored(const PinMotion& motion, const Mirror& mirror) {
    PinMotion image = motion;
    std::visit([&mirror](auto& kind) { change(kind, mirror); }, image.kind);
    return image;
}

Region<3> mirrored(const Region<3>& region, const Mirror& mirror) {
    Region<3> image = region;
    std::visit([&mirror](auto& shape) { change(shape, mirror); }, image);
    return image;
}

std::vector<CopiedKey> mirroredKeys(const ShapeFrame& frame, const std::vector<Pin>& handles,
                                    std::vector<CopiedKey> copies) {
    const Mirror mirror = mirrorOf(frame);
    const std::vector<int> images = mirrorImages(frame, handles);
    for (CopiedKey& copy : copies) {
        copy.handle = images.at(static_cast<std::size_t>(copy.handle));
        copy.offset = mirror.along(copy.offset);
    }
    return copies;
}

void mirrorPins(ShapeSession& session) {
    const FramePtr frame = session.motion().frame();
    if (!frame) return;
    Document& document = session.document();
    const Imager imager(*frame);
    Design next = document.design();
    auto& handles = next.handles;
    std::vector<int> made;
    bool beside = false, taken = false;
    for (const int h : session.selection().handles()) {
        auto image = imager(handles[h]);
        beside = beside || !image;
        const bool isTaken = image && imager.isTaken(*image, handles);
        taken = taken || isTaken;
        if (!image || isTaken) continue;
        image->name = freeImageName(handles, handles[h].name);
        made.push_back(static_cast<int>(handles.size()));
        handles.push_back(std::move(*image));
    }
    if (beside)
        session.document().notify(
            ShapeSession::tr("No pin was set where the mirror image lies outside the shape."));
    else if (taken)
        session.document().notify(
            ShapeSession::tr("There is already a pin where the mirror image would be."));
    if (made.empty()) return;
    document.changeDesign(
        ShapeSession::tr("Mirror %1").arg(session.pins().nameOf(session.selection().handles())),
        std::move(next));
    session.selection().set(made);
}

void mirrorMotion(ShapeSession& session) {
    const FramePtr frame = session.motion().frame();
    if (!frame) return;
    Document& document = session.document();
    Design next = document.design();
    auto& handles = next.handles;
    std::vector<int> moved;
    std::vector<Vec3> starts;
    for (const int h : session.selection().handles()) {
        const auto own = session.pins().pathStarts(h);
        if (handles[h].motions.empty() || own.empty() || !session.gestures().mayChange(h)) continue;
        moved.push_back(h);
        starts.push_back(meanOf(own));
    }
    if (moved.empty()) return;
    Mirror mirror = mirrorOf(*frame);
    mirror.at = meanOf(starts)[mirror.axis];
    for (const int h : moved)
        for (PinMotion& motion : handles[h].motions) motion = mirrored(motion, mirror);
    document.changeDesign(ShapeSession::tr("Mirror the motion of %1").arg(session.pins().nameOf(moved)),
                          std::move(next));
}

Mirror mirrorOf(const ShapeFrame& frame) {
    return mirrorOf(frame, *RestPlaces::of(frame));
}

std::vector<int> mirrorImages(const ShapeFrame& frame, const std::vector<Pin>& handles) {
    const Imager imager(frame);
    std::vector<int> images;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h)
        images.push_back(imager.counterpart(handles, h));
    return images;
}

bool canMirrorMotion(const ShapeSession& session) {
    if (session.document().isEmpty()) return false;
    const auto& handles = session.document().design().handles;
    return std::ranges::any_of(session.selection().handles(), [&](int h) {
        return h < static_cast<int>(handles.size()) && !handles[h].motions.empty();
    });
}

}  // namespace wend
