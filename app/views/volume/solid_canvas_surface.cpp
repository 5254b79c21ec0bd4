// The interface of a solid's view for tools.
#include <cmath>
#include <limits>

#include "app/engine/motion/pose_places.h"
#include "app/engine/shape/shape.h"
#include "app/views/volume/skin_marks.h"
#include "app/views/volume/solid_canvas.h"

namespace wend {

namespace {

constexpr std::size_t kMostRays = 4000;  // vertices of one handle beyond which all count as visible
}  // namespace

Ray SolidCanvas::ray(const QPointF& widget) const {
    return camera().ray({widget.x(), widget.y()}, size());
}

QPointF SolidCanvas::onScreen(const Vec<3>& p) const {
    const Vec<3> screen = camera().project(p, size());
    return {screen.x(), screen.y()};
}

std::vector<int> SolidCanvas::verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                            bool visibleOnly) const {
    std::vector<int> found;
    if (!showsFrame()) return found;
    const Points<3>& pose = shown().pose;
    for (Eigen::Index v = 0; v < pose.cols(); ++v) {
        const Vec<3> screen = camera().project(pose.col(v), size());
        if (std::abs(screen.z()) <= 1 && !isCutOff(pose.col(v)) && inside({screen.x(), screen.y()}))
            found.push_back(static_cast<int>(v));
    }
    if (visibleOnly) keepVisible(found);
    return found;
}

/// Returns whether the frame is shown, rather than a file's surface or an earlier mesh with other cells and
/// vertices.
bool SolidCanvas::showsFrame() const {
    const auto frame = m_session.frame<3>();
    return frame && shown().rest == frame->rest;
}

SolidHit SolidCanvas::pick(const QPointF& widget) const {
    return showsFrame() ? VolumeView::pick(widget) : SolidHit{};
}

std::optional<Touch> SolidCanvas::touch(const QPointF& widget) const {
    const SolidHit hit = pick(widget);
    if (hit.cell < 0) return {};
    Place place = m_session.frame()->placeIn(hit.cell, hit.point);
    // A surface may reach out of the solid that takes it along.
    place.weights = place.weights.cwiseMax(0);
    place.weights /= place.weights.sum();
    return Touch{place, hit.point};
}

void SolidCanvas::showMaterial(const FramePtr& painted, bool lasts) {
    m_preview.set(m_session.frame<3>(), posed<3>(painted), lasts);
    refresh();
}

/// Whole cells reach beyond the plane: points on the drawn surface are not cut off.
bool SolidCanvas::isHidden(const Vec<3>& p) const {
    const Ray sight = ray(onScreen(p));
    const SolidHit hit = hitOf(sight);
    const double within = 2 * pixelSize(p);
    const double before = hit.cell < 0
                              ? -std::numeric_limits<double>::infinity()
                              : (p - sight.origin).dot(sight.direction) - (hit.point - sight.origin).norm();
    return before > within || (isCutOff(p) && before < -within);
}

/// Asks through its middle and those of its sides.
std::optional<Vec3> SolidCanvas::placeOf(const ShapeFrame&, int cell) const {
    if (!showsFrame()) return {};
    const Points<3>& pose = shown().pose;
    const Cell<3>& corners = shown().rest->cells[cell];
    Vec<3> sum = Vec<3>::Zero();
    for (const int v : corners) sum += pose.col(v);
    std::vector<Vec<3>> middles = {sum / 4};
    for (const int v : corners) middles.push_back((sum - pose.col(v)) / 3);
    for (const Vec<3>& middle : middles) {
        const SolidHit hit = hitOf(ray(onScreen(middle)));
        if (hit.cell == cell) return hit.point;
    }
    return {};
}

std::vector<VertexMark> SolidCanvas::marksOf(const std::vector<int>& vertices) const {
    const Points<3>& pose = shown().pose;
    // Without a frame of this mesh the picture is a preview.
    const bool isSkin = showsSkin() && static_cast<Eigen::Index>(skinPoints().size()) == pose.cols();
    const bool asks = vertices.size() <= kMostRays;
    std::vector<VertexMark> marks;
    for (const int v : vertices) {
        if (v >= pose.cols()) continue;
        const int point = isSkin ? skinPoints()[static_cast<std::size_t>(v)] : -1;
        const Vec<3> at = point < 0 ? Vec<3>(pose.col(v)) : Vec<3>(skinPose().col(point));
        if (!isCutOff(at) && !isCutOff(pose.col(v))) marks.push_back({at, asks && isHidden(pose.col(v))});
    }
    return marks;
}

/// Cached per skin.
const std::vector<int>& SolidCanvas::skinPoints() const {
    const VolumePicture& picture = shown();
    if (m_marked != picture.skin)
        m_skinPoints = nearestSkinPoints(*picture.skin, picture.rest->points, *picture.facets);
    m_marked = picture.skin;
    return m_skinPoints;
}

}  // namespace wend
