// From where a solid is seen, and what of it is kept with its project.
#include "app/view/volume/solid_canvas.h"

namespace wend {

/// As every document is seen that brings no camera.
void SolidCanvas::lookAtFirst() {
    camera().setUpAxis(m_session.document().up());
    camera().setOrthographic(false);
    look(Camera::Axis::Isometric);
}

/// After it has been fitted: how far it reaches in depth follows from that.
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

/// One that nobody has moved is kept as the document brought it, or not at all.
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
