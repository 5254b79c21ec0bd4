// The viewpoint of a solid and its storage in the project.
#include <algorithm>

#include "app/project/design.h"
#include "app/session/pins/pin_shapes.h"
#include "app/views/volume/solid_canvas.h"

namespace wend {

namespace {

/// Adds the directions of a selected curve, which may be far from it.
void addDirections(const Pin& handle, const PinPath& path, std::vector<Vec<3>>& points) {
    for (const PinMotion& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
        const auto at = std::lower_bound(path.times.begin(), path.times.end(), motion.start);
        if (!curve || curve->points.empty() || at == path.times.end()) continue;
        const Vec<3> start = path.points[static_cast<std::size_t>(at - path.times.begin())];
        for (const Vec<3>& p : curve->points) points.push_back(start + p - curve->points.front());
    }
}

/// Returns the points of the pins and their paths as they are drawn.
std::vector<Vec<3>> pathPoints(ShapeSession& session) {
    std::vector<Vec<3>> points;
    for (const PinView& view : session.pins()) points.push_back(view.centre);
    const auto& handles = session.document().design().handles;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        const auto starts = session.pathStarts(h);
        if (handles[h].motions.empty() || starts.empty() || handles[h].traits.hidden) continue;
        for (const PinPath& path : pinPaths(handles[h], shownStarts(starts), 3)) {
            points.insert(points.end(), path.points.begin(), path.points.end());
            if (session.selection().contains(h)) addDirections(handles[h], path, points);
        }
    }
    return points;
}

}  // namespace

/// Returns the points to fit the view to, with pins and paths.
Points<3> SolidCanvas::fitted() const {
    const Points<3> drawn = VolumeView::fitted();
    if (m_viewport.looks().hidden || !m_session.frame<3>()) return drawn;
    const std::vector<Vec<3>> marked = pathPoints(m_session);
    Points<3> all(3, drawn.cols() + static_cast<Eigen::Index>(marked.size()));
    all.leftCols(drawn.cols()) = drawn;
    for (std::size_t i = 0; i < marked.size(); ++i)
        all.col(drawn.cols() + static_cast<Eigen::Index>(i)) = marked[i];
    return all;
}

/// Sets the default view for documents without a camera.
void SolidCanvas::lookAtFirst() {
    camera().setUpAxis(m_session.document().up());
    camera().setOrthographic(false);
    look(Camera::Axis::Isometric);
}

/// Restores the camera after fitting, which sets the depth range.
void SolidCanvas::takeKeptCamera() {
    const auto& kept = m_session.document().camera();
    m_asOpened.reset();
    if (!kept) return;
    camera().restore(*kept);
    m_asOpened = camera().saved();
    m_fitted = false;
    update();
    emit cameraChanged();
}

void SolidCanvas::takeUpAxis() {
    const Document& document = m_session.document();
    if (document.dimension() != 3 || document.generation() != m_generation) return;
    const UpAxis up = document.up();
    if (up == camera().upAxis()) return;
    camera().setUpAxis(up);
    fit();
}

/// Keeps the document's camera unless the user has moved it.
void SolidCanvas::keepCamera() {
    Document& document = m_session.document();
    if (!m_session.frame<3>() || document.generation() != m_generation) return;
    const SavedCamera now = camera().saved();
    if (m_asOpened == now) return;
    Camera first = camera();
    first.setOrthographic(false);
    first.look(Camera::Axis::Isometric);
    const bool isTurned = now.parallel || !first.direction().isApprox(camera().direction(), 1e-6);
    if (!m_fitted) first.fit(fitted(), size());
    document.setCamera(isTurned || (!m_fitted && first.saved() != now) ? std::optional(now) : std::nullopt);
}

}  // namespace wend
