#include "app/views/volume/solid_viewpoint.h"

#include <utility>

namespace wend {

bool SolidViewpoint::begin() {
    if (std::exchange(m_generation, m_document.generation()) == m_document.generation()) return false;
    m_isFitted = true;
    lookAtFirst();
    return true;
}

void SolidViewpoint::lookAtFirst() {
    m_view.camera().setUpAxis(m_document.up());
    m_view.camera().setOrthographic(false);
    m_view.look(Camera::Axis::Isometric);
}

void SolidViewpoint::restore() {
    const auto& kept = m_document.camera();
    m_asOpened.reset();
    if (!kept) return;
    m_isFitted = false;
    Camera camera = m_view.camera();
    camera.restore(*kept);
    m_asOpened = camera.saved();
    m_view.setCamera(camera);
}

void SolidViewpoint::takeUpAxis() {
    const UpAxis up = m_document.up();
    if (m_document.dimension() != 3 || !isOfDocument() || up == m_view.camera().upAxis()) return;
    m_view.camera().setUpAxis(up);
    m_view.fit();
}

void SolidViewpoint::keep() {
    const Camera& camera = m_view.camera();
    const SavedCamera now = camera.saved();
    if (!isOfDocument() || m_asOpened == now) return;
    Camera first = camera;
    first.setOrthographic(false);
    first.look(Camera::Axis::Isometric);
    const bool isTurned = now.parallel || !first.direction().isApprox(camera.direction(), 1e-6);
    if (!m_isFitted) first.fit(m_view.fitted(), m_view.size());
    const bool isKept = isTurned || (!m_isFitted && first.saved() != now);
    m_document.setCamera(isKept ? std::optional(now) : std::nullopt);
}

void SolidViewpoint::lookAlong(const Vec<3>& direction) {
    m_view.camera().lookAlong(direction);
    m_isFitted = true;
    m_view.fit();
}

void SolidViewpoint::zoomTo(const Points<3>& points) {
    m_isFitted = false;
    Camera camera = m_view.camera();
    camera.fit(points, m_view.size());
    m_view.setCamera(camera);
}

}  // namespace wend
