// The view of a solid as a picture of any size.
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

#include "app/views/volume/volume_view.h"

namespace wend {

namespace {

constexpr int kPictureSamples = 4;

void putTile(QImage& image, const QPoint& at, const QImage& tile) {
    QPainter painter(&image);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(at, tile);
}

}  // namespace

/// A part of the picture: the projection blown up so that the part fills the tile.
QImage VolumeView::tile(const QRect& part, const QSize& whole, const QColor& background) {
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(kPictureSamples);
    QOpenGLFramebufferObject buffer(part.size(), format);
    if (!buffer.isValid() || !buffer.bind()) return {};
    context()->functions()->glViewport(0, 0, part.width(), part.height());
    Eigen::Matrix4d toTile = Eigen::Matrix4d::Identity();
    const Eigen::Vector2d scale(static_cast<double>(whole.width()) / part.width(),
                                static_cast<double>(whole.height()) / part.height());
    const QPointF middle = QRectF(part).center();
    toTile.diagonal().head<2>() = scale;
    toTile(0, 3) = scale.x() * (1 - 2 * middle.x() / whole.width());
    toTile(1, 3) = -scale.y() * (1 - 2 * middle.y() / whole.height());
    const double pixelsPer = whole.height() / static_cast<double>(std::max(1, height()));
    drawScene({m_camera.view(), toTile * m_camera.projection(whole), m_camera.orthographic(), part.size(),
               pixelsPer},
              background);
    const QImage image = buffer.toImage();
    buffer.release();
    return image;
}

QString VolumeView::obstacle() const {
    return m_ready ? QString() : tr("The solid cannot be drawn: %1").arg(m_renderer.error());
}

QImage VolumeView::pictureRows(const QSize& size, int top, int rows, bool transparent) {
    if (!m_ready) return {};
    QImage image(size.width(), rows, QImage::Format_ARGB32_Premultiplied);
    if (image.isNull()) return {};
    makeCurrent();
    GLint most = m_largestTile;
    context()->functions()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    const int step = std::min<int>(m_largestTile, most);
    for (int y = 0; y < rows && !image.isNull(); y += step)
        for (int x = 0; x < size.width() && !image.isNull(); x += step) {
            const QRect part = QRect(x, y, step, step) & image.rect();
            const QImage piece =
                tile(part.translated(0, top), size, transparent ? QColor(0, 0, 0, 0) : background());
            if (!piece.isNull()) putTile(image, part.topLeft(), piece);
            if (piece.isNull()) image = {};
        }
    doneCurrent();
    m_painted.reset();  // invalidates the view's buffer, too
    update();
    return image;
}

}  // namespace wend
