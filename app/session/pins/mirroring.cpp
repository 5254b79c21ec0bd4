#include "app/session/pins/mirroring.h"

#include <algorithm>
#include <limits>
#include <set>

#include "app/engine/motion/pose_places.h"
#include "app/project/design.h"

namespace wend {

namespace {

constexpr double kReach = 0.02;  // fraction of the shape's size that an image may be off the shape
constexpr double kSame = 1e-3;   // of the shape's size: closer pins are one
constexpr int kSamples = 500;    // of the vertices
constexpr double kPaired =
    0.1;  // of the shape's size: a pin that is nearer to the image of another is its counterpart

/// Returns the mean length of an edge, using one of each cell.
template <int Dim>
double edgeOf(const SimplicialMesh<Dim>& mesh) {
    double sum = 0;
    for (const Cell<Dim>& cell : mesh.cells)
        sum += (mesh.points.col(cell[1]) - mesh.points.col(cell[0])).norm();
    return sum / mesh.cellCount();
}

/// Returns the mean distance of mirrored vertices from their nearest vertices; values below an edge length
/// are noise.
template <int Dim>
double unlikeness(const SimplicialMesh<Dim>& rest, const PointLocator<Dim>& locator, const Mirror& mirror) {
    const int step = std::max(1, rest.vertexCount() / kSamples);
    double sum = 0;
    int count = 0;
    for (int v = 0; v < rest.vertexCount(); v += step, ++count) {
        const Vec<Dim> image = mirror(inSpace(Vec<Dim>(rest.points.col(v)))).template head<Dim>();
        sum += (rest.points.col(locator.nearestVertex(image)) - image).norm();
    }
    return std::max(sum / count, edgeOf(rest));
}

/// Makes mirror images of handles in a rest mesh.
template <int Dim>
class Imager {
  public:
    explicit Imager(const PosedFrame<Dim>& frame)
        : m_rest(*frame.rest),
          m_locator(frame.rest->points, frame.rest->cells),
          m_mirror(mirrorOf<Dim>(*frame.rest)),
          m_size(frame.diagonal) {}

    /// Returns nothing if the image would be outside the shape.
    std::optional<Pin> operator()(const Pin& handle) const {
        Pin image = handle;
        Placement<Dim> place = placementIn<Dim>(handle.at);
        const bool lies = std::visit([this](auto& at) { return this->move(at); }, place);
        image.at = inSpace(place);
        for (PinMotion& motion : image.motions) motion = mirrored(motion, m_mirror);
        if (image.normal) image.normal = m_mirror.along(*image.normal);
        image.traits.locked = image.traits.hidden = false;
        image.traits.link = 0;
        image.traits.colour.reset();
        return lies ? std::optional(image) : std::nullopt;
    }
    /// Returns whether a handle already holds the same place.
    bool isTaken(const Pin& image, const std::vector<Pin>& handles) const {
        const Vec<Dim> own = middleOf(image);
        return std::any_of(handles.begin(), handles.end(),
                           [&](const Pin& other) { return (middleOf(other) - own).norm() < kSame * m_size; });
    }

    /// Returns the number of the handle that is nearest to the image of one.
    int counterpart(const std::vector<Pin>& handles, int of) const {
        const Vec<Dim> image = imageOf(middleOf(handles[of]));
        int best = of;
        double least = kPaired * m_size;
        for (int h = 0; h < static_cast<int>(handles.size()); ++h)
            if (const double off = (middleOf(handles[h]) - image).norm(); off < least) least = off, best = h;
        return best;
    }

  private:
    Vec<Dim> imageOf(const Vec<Dim>& p) const { return m_mirror(inSpace(p)).template head<Dim>(); }
    int nearest(const Vec<Dim>& p) const {
        const int v = m_locator.nearestVertex(p);
        return (m_rest.points.col(v) - p).norm() <= kReach * m_size ? v : -1;
    }
    bool move(std::vector<int>& vertices) const {
        std::set<int> images;
        for (const int v : vertices)
            if (v < m_rest.vertexCount()) images.insert(nearest(imageOf(m_rest.points.col(v))));
        images.erase(-1);
        vertices.assign(images.begin(), images.end());
        return !vertices.empty();
    }
    bool move(std::vector<Vec<Dim>>& points) const {
        std::vector<Vec<Dim>> images;
        for (const Vec<Dim>& p : points) {
            const Vec<Dim> image = imageOf(p);
            if (m_locator.find(image, 1e-9))
                images.push_back(image);
            else if (const int v = nearest(image); v >= 0)
                images.push_back(m_rest.points.col(v));
        }
        points = images;
        return !points.empty();
    }
    bool move(Region<Dim>& region) const {
        region = regionIn<Dim>(mirrored(inSpace(region), m_mirror));
        return !verticesInside<Dim>(region, m_rest).empty();
    }
    Vec<Dim> middleOf(const Pin& handle) const {
        std::vector<Vec<Dim>> points;
        const auto places = placePins<Dim>({handle}, m_rest, m_locator);
        for (const auto& place : places.front().points)
            points.push_back(positionOf<Dim>(place, m_rest, m_rest.points));
        return points.empty() ? Vec<Dim>(Vec<Dim>::Constant(std::numeric_limits<double>::infinity()))
                              : meanOf<Dim>(points);
    }

    const SimplicialMesh<Dim>& m_rest;
    PointLocator<Dim> m_locator;
    Mirror m_mirror;
    double m_size;
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

template <int Dim>
void mirrorPinsOf(ShapeSession& session) {
    const auto frame = session.frame<Dim>();
    if (!frame) return;
    Document& document = session.document();
    const Imager<Dim> imager(*frame);
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
        session.notify(ShapeSession::tr("No pin was set where the mirror image lies outside the shape."));
    else if (taken)
        session.notify(ShapeSession::tr("There is already a pin where the mirror image would be."));
    if (made.empty()) return;
    document.changeDesign(ShapeSession::tr("Mirror %1").arg(session.nameOf(session.selection().handles())),
                          std::move(next));
    session.selection().set(made);
}

template <int Dim>
void mirrorMotionOf(ShapeSession& session) {
    const auto frame = session.frame<Dim>();
    if (!frame) return;
    Document& document = session.document();
    Design next = document.design();
    auto& handles = next.handles;
    std::vector<int> moved;
    std::vector<Vec<Dim>> starts;
    for (const int h : session.selection().handles()) {
        const auto own = session.pathStarts<Dim>(h);
        if (handles[h].motions.empty() || own.empty() || !session.mayChange(h)) continue;
        moved.push_back(h);
        starts.push_back(meanOf<Dim>(own));
    }
    if (moved.empty()) return;
    Mirror mirror = mirrorOf<Dim>(*frame->rest);
    mirror.at = meanOf<Dim>(starts)[mirror.axis];
    for (const int h : moved)
        for (PinMotion& motion : handles[h].motions) motion = mirrored(motion, mirror);
    document.changeDesign(ShapeSession::tr("Mirror the motion of %1").arg(session.nameOf(moved)),
                          std::move(next));
}

}  // namespace

template <int Dim>
Mirror mirrorOf(const SimplicialMesh<Dim>& rest) {
    const Vec<Dim> middle = (rest.points.rowwise().minCoeff() + rest.points.rowwise().maxCoeff()) / 2;
    Mirror best{0, middle[0]};
    if (Dim == 2) return best;
    const PointLocator<Dim> locator(rest.points, rest.cells);
    double least = unlikeness(rest, locator, best);
    for (int k = 1; k < Dim; ++k) {
        const Mirror other{k, middle[k]};
        const double unlike = unlikeness(rest, locator, other);
        if (unlike < least) least = unlike, best = other;
    }
    return best;
}

template <int Dim>
std::vector<int> mirrorImages(const PosedFrame<Dim>& frame, const std::vector<Pin>& handles) {
    const Imager<Dim> imager(frame);
    std::vector<int> images;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h)
        images.push_back(imager.counterpart(handles, h));
    return images;
}

void mirrorPins(ShapeSession& session) {
    session.document().dimension() == 2 ? mirrorPinsOf<2>(session) : mirrorPinsOf<3>(session);
}

void mirrorMotion(ShapeSession& session) {
    session.document().dimension() == 2 ? mirrorMotionOf<2>(session) : mirrorMotionOf<3>(session);
}

bool canMirrorMotion(const ShapeSession& session) {
    if (session.document().isEmpty()) return false;
    const auto& handles = session.document().design().handles;
    return std::ranges::any_of(session.selection().handles(), [&](int h) {
        return h < static_cast<int>(handles.size()) && !handles[h].motions.empty();
    });
}

template std::vector<int> mirrorImages<2>(const PosedFrame<2>&, const std::vector<Pin>&);
template std::vector<int> mirrorImages<3>(const PosedFrame<3>&, const std::vector<Pin>&);
template Mirror mirrorOf<2>(const SimplicialMesh<2>&);
template Mirror mirrorOf<3>(const SimplicialMesh<3>&);

}  // namespace wend
