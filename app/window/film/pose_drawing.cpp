#include "app/window/film/pose_drawing.h"

#include "app/base/in_background.h"
#include "app/views/canvas/canvas.h"
#include "app/views/volume/solid_canvas.h"

namespace wend {

PoseDrawing::PoseDrawing(const ShapeCanvas& picture, std::function<SolidCanvas*()> solid, QObject* parent)
    : QObject(parent), m_picture(picture), m_solid(std::move(solid)) {}

void PoseDrawing::draw(const FramePtr& frame, const QSize& size, std::function<void(const QImage&)> take) {
    if (const auto solid = posed<3>(frame))
        return take(m_solid() ? m_view.draw(*m_solid(), *solid, size) : QImage());
    const auto request = m_picture.shape().smallRequest(posed<2>(frame), size);
    if (!request) return take({});
    inBackground(
        this, [request = *request] { return RenderThread::render(request); }, std::move(take));
}

}  // namespace wend
