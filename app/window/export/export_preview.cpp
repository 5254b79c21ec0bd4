#include "app/window/export/export_preview.h"

#include <Eigen/LU>
#include <QPainter>
#include <cmath>

#include "app/engine/shape/shape.h"
#include "app/output/layer_export.h"
#include "app/output/svg_export.h"
#include "app/views/canvas/ground.h"
#include "app/views/canvas/render_thread.h"
#include "warp/convert.h"
#include "warp/film_format.h"
#include "warp/image_formats.h"
#include "warp/warp.h"

namespace wend {

namespace {

constexpr int kFrameMargin = 12;  // around the picture in its frame

/// Returns the same part of the plane with fewer pixels.
View smaller(const View& view, const QSize& room) {
    const QSizeF size = QSizeF(view.width, view.height).scaled(room, Qt::KeepAspectRatio);
    View small = view;
    if (size.width() >= view.width) return view;
    small.width = std::max(1, static_cast<int>(std::lround(size.width())));
    small.height = std::max(1, static_cast<int>(std::lround(size.height())));
    small.scale = view.scale * view.width / small.width;
    return small;
}

View viewOf(const FrameExport& shape, const PreviewRequest& request) {
    return shape.view(request.kind, request.options.canvas, request.options.outputs.loop);
}

QImage picturePreview(const FrameExport& shape, const ScreenPicture& picture, const PreviewRequest& request,
                      std::stop_token stop) {
    WarpOptions options = shape.warpOptions(request.options);
    options.stop = std::move(stop);
    const View view = smaller(viewOf(shape, request), request.room);
    if (view.scale != 1) options.restMargin = 0;  // in pixels of the picture in its own size
    QImage warped = picture.warped(shape.restInPixels(), shape.poseInPixels(), view, options);
    if (warped.isNull()) return warped;  // stopped
    const std::string file = "picture" + request.extension;
    const FilmFormatFacts* film = request.kind == ExportKind::Film ? filmFormatOf(file) : nullptr;
    if (film ? film->alpha : holdsAlpha(file) || isLayeredFile(file) || isSvgFile(file)) return warped;
    QImage opaque(warped.size(), QImage::Format_RGB32);
    opaque.fill(Qt::white);
    QPainter(&opaque).drawImage(0, 0, warped);
    return opaque;
}

/// Returns the map's red and green, as a compositing program shows them.
QImage mapPreview(const FrameExport& shape, const PreviewRequest& request) {
    const View view = smaller(viewOf(shape, request), request.room);
    const Image map = shape.stMapOf(view);
    const Image shown = converted(map, {PixelType::UInt8, 4, true, true});
    return QImage(reinterpret_cast<const uchar*>(shown.data.data()), shown.width, shown.height,
                  static_cast<qsizetype>(shown.rowBytes()), QImage::Format_RGBA8888)
        .copy();
}

QImage meshPreview(const FrameExport& shape, const std::shared_ptr<const ScreenPicture>& picture,
                   const PreviewRequest& request) {
    RenderRequest draw;
    draw.picture = picture;
    draw.frame = posed<2>(shape.frame());
    draw.texture = draw.frame->built->texture;
    draw.plan = std::make_shared<PaintingPlan>(*drawnRest(*draw.frame->built), shape.depths());
    draw.mesh = true;
    draw.fill = request.fill;
    draw.line = request.line;
    draw.filter = Filter::Bilinear;
    draw.size = request.room;
    const Extent<2> extent = extentOf<2>(draw.frame->pose, draw.frame->rest->cells);
    const Mat2 A = draw.texture ? draw.texture->toPixels.A : Mat2::Identity();
    draw.view.setPointsUp(draw.texture ? A.determinant() < 0 : !picture);
    draw.view.setZoomLimits(1e-9, 1e9);
    const Vec2 size = extent.high - extent.low;
    draw.view.fit({extent.low.x(), extent.low.y(), size.x(), size.y()}, request.room, kFrameMargin);
    return RenderThread::render(draw);
}

}  // namespace

QImage exportPreview(const FrameExport& shape, const std::shared_ptr<const ScreenPicture>& picture,
                     const PreviewRequest& request, std::stop_token stop) {
    QImage image;
    if (request.kind == ExportKind::StMap)
        image = mapPreview(shape, request);
    else if (request.kind == ExportKind::Film || canWriteImage("picture" + request.extension) ||
             isLayeredFile("picture" + request.extension) || isSvgFile("picture" + request.extension))
        image = picturePreview(shape, *picture, request, std::move(stop));
    else if (shape.dimension() == 2)
        image = meshPreview(shape, picture, request);
    image.setDevicePixelRatio(request.ratio);
    return image;
}

ExportPreview::ExportPreview(QWidget* parent, const QSize& least, const QSize& wanted)
    : QWidget(parent), m_wanted(wanted) {
    setMinimumSize(least);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Preview"));
    setAccessibleDescription(tr("What will be written, smaller"));
}

QSize ExportPreview::room() const {
    return (QSizeF(size() - QSize(2 * kFrameMargin, 2 * kFrameMargin)) * devicePixelRatioF())
        .toSize()
        .expandedTo({16, 16});
}

QRectF ExportPreview::place() const {
    const QSizeF frame =
        QSizeF(this->size()).shrunkBy({kFrameMargin, kFrameMargin, kFrameMargin, kFrameMargin});
    QSizeF size = m_image.deviceIndependentSize();
    if (size.boundedTo(frame) != size) size.scale(frame, Qt::KeepAspectRatio);
    return {QPointF(std::round((width() - size.width()) / 2), std::round((height() - size.height()) / 2)),
            size};
}

void ExportPreview::setImage(const QImage& image) {
    m_image = image;
    if (image.hasAlphaChannel()) m_lightness = lightnessOf(image);
    m_current = true;
    update();
}

void ExportPreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = Theme::of(palette());
    painter.setPen(theme.line);
    painter.setBrush(theme.workspace);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
    if (m_image.isNull()) return;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRectF place = this->place();
    if (m_image.hasAlphaChannel() && !property("bare").toBool())
        fillWithChecks(painter, place, theme.behind(m_lightness));
    painter.drawImage(place, m_image);
}

}  // namespace wend
