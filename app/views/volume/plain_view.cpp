#include "app/views/volume/plain_view.h"

#include "app/views/volume/solid_canvas.h"

namespace wend {

QImage PlainView::draw(const SolidCanvas& like, const PosedFrame<3>& frame, const QSize& size) {
    if (!m_view) {
        m_view = new VolumeView(like.parentWidget());
        m_view->hide();
    }
    m_view->setStyle(like.solidLook().plainStyle());
    m_view->setPicture(like.solidLook().plainPicture(frame), false);
    m_view->resize(size);
    m_view->camera() = like.camera();
    m_view->fit();
    if (!m_view->obstacle().isEmpty()) m_view->grabFramebuffer();  // the first time: makes its context
    return m_view->picture(size, true);
}

}  // namespace wend
