#include "app/views/volume/volume_view.h"
#include "app/session/shape_session.h"

#include <Eigen/Geometry>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QWheelEvent>
#include <array>
#include <cmath>
#include <map>

namespace wend {

namespace {

constexpr int kSamples = 4;                     // of a pixel, where edges are smoothed
constexpr double kSlow = 16, kQuickEnough = 3;  // milliseconds of a drawing by the processor
constexpr int kEasy = 600'000;                  // pixels that are always drawn
constexpr int kRestAfter = 160;                 // milliseconds without motion

QSurfaceFormat glFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

/// Makes the buffer anew if it has another size: that of the view's buffer changes without a resize on
/// another screen. Returns false if memory is insufficient.
bool bindBuffer(std::unique_ptr<QOpenGLFramebufferObject>& buffer, const QSize& pixels, int samples) {
    if (!buffer || buffer->size() != pixels) {
        QOpenGLFramebufferObjectFormat format;
        format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
        format.setSamples(samples);
        buffer = std::make_unique<QOpenGLFramebufferObject>(pixels, format);
    }
    if (buffer->isValid() && buffer->bind()) return true;
    QOpenGLFramebufferObject::bindDefault();
    return false;
}

Eigen::Vector2d pixelOf(const QPointF& p) {
    return {p.x(), p.y()};
}

void putTile(QImage& image, const QPoint& at, const QImage& tile) {
    QPainter painter(&image);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(at, tile);
}

}  // namespace

VolumeView::VolumeView(QWidget* parent) : QOpenGLWidget(parent) {
    QSurfaceFormat format = glFormat();
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    setFormat(format);
    setUpdateBehavior(PartialUpdate);  // repainting marks does not redraw the solid
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestAfter);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        if (!isMoving()) update();
    });
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("View of the solid"));
    connect(this, &VolumeView::cameraChanged, this, qOverload<>(&QWidget::update));
    m_camera.look(Camera::Axis::Isometric);
}

VolumeView::~VolumeView() {
    if (context()) disconnect(context(), nullptr, this, nullptr);
    releaseGl();
}

void VolumeView::releaseGl() {
    makeCurrent();
    m_solid.release();
    m_fine.reset();
    m_coarse.reset();
    m_ready = false;
    doneCurrent();
}

bool VolumeView::available() {
    QOpenGLContext context;
    context.setFormat(glFormat());
    return context.create() && context.format().version() >= qMakePair(3, 3);
}

void VolumeView::setPicture(VolumePicture picture, bool fitView) {
    m_solid.setPicture(std::move(picture));
    update();
    if (fitView) fit();
}

void VolumeView::setGlyphs(std::vector<DrawVertex> triangles, std::vector<DrawVertex> veiled) {
    if (m_solid.setGlyphs(std::move(triangles), std::move(veiled))) update();
}

void VolumeView::fit() {
    const Points3& pose = m_solid.picture().pose;
    if (pose.cols() == 0) return;
    m_camera.fit(fitted(), size());
    m_camera.setPivot((pose.rowwise().minCoeff() + pose.rowwise().maxCoeff()) / 2);
    emit cameraChanged();
}

void VolumeView::look(Camera::Axis axis) {
    m_camera.look(axis);
    emit cameraChanged();
}

void VolumeView::setOrthographic(bool on) {
    m_camera.setOrthographic(on);
    emit cameraChanged();
}

SolidHit VolumeView::pick(const QPointF& pixel) const {
    return m_solid.hit(m_camera.ray(pixelOf(pixel), size()));
}

std::vector<int> VolumeView::verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                           bool visibleOnly) const {
    const Points3& pose = m_solid.picture().pose;
    const auto isCovered = [this](const Vec3& p, const Vec3& screen) {
        const Ray sight = m_camera.ray(screen.head<2>(), size());
        const SolidHit hit = m_solid.hit(sight);
        // A vertex of the surface is met by the ray itself, up to rounding.
        return hit.cell >= 0 &&
               (hit.point - sight.origin).norm() < (p - sight.origin).dot(sight.direction) * (1 - 1e-4);
    };
    std::vector<int> found;
    for (Eigen::Index v = 0; v < pose.cols(); ++v) {
        const Vec3 p = pose.col(v), screen = m_camera.project(p, size());
        if (std::abs(screen.z()) > 1 || m_solid.isCutOff(p) || !inside({screen.x(), screen.y()})) continue;
        if (!visibleOnly || !isCovered(p, screen)) found.push_back(static_cast<int>(v));
    }
    return found;
}

/// Called for every new context, such as after a change of the window, which has no resources yet.
void VolumeView::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VolumeView::releaseGl,
            static_cast<Qt::ConnectionType>(Qt::DirectConnection | Qt::UniqueConnection));
    m_ready = m_solid.initialize();
    m_painted.reset();
}

void VolumeView::resizeGL(int, int) {
    m_fine.reset();
    m_coarse.reset();
    m_painted.reset();
}

/// Prepares the solid and draws it. The background of a transparent picture is unknown.
void VolumeView::drawScene(const Sight& sight, const QColor& background) {
    auto* gl = context()->functions();
    gl->glClearColor(background.redF(), background.greenF(), background.blueF(), background.alphaF());
    gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    QElapsedTimer clock;
    clock.start();
    const QStringList unread = m_solid.upload();
    m_times.prepare = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    m_solid.draw(sight, background.alpha() == 255);
    if (!unread.isEmpty()) emit picturesMissing(unread);
}

/// Antialiased edges are slow on a CPU: they are drawn when nothing moves.
VolumeView::Scene VolumeView::scene() const {
    const Sight sight{m_camera.view(), m_camera.projection(size()), m_camera.orthographic(),
                      size() * devicePixelRatioF(), devicePixelRatioF()};
    return {sight, m_solid.style(), background(), m_solid.isSoftware() && isMoving(),
            m_solid.picture().materials};
}

bool VolumeView::isSettled() const {
    return m_painted && !m_painted->coarse && *m_painted == scene() && !m_solid.isStale();
}

QColor VolumeView::background() const {
    return m_background.isValid() ? m_background : palette().color(QPalette::Base).darker(104);
}

/// Draws with antialiased edges; with those of single pixels if memory is insufficient.
void VolumeView::drawFinely(const Scene& scene) {
    const bool isFine = bindBuffer(m_fine, scene.sight.pixels, kSamples);
    drawScene(scene.sight, scene.background);
    if (!isFine) return;
    QOpenGLFramebufferObject::bindDefault();
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, m_fine.get());
}

/// Draws what moves: with fewer pixels, which are enlarged, if the last such drawings took too long.
void VolumeView::drawCoarsely(const Scene& scene) {
    Sight sight = scene.sight;
    const QSize all = sight.pixels;
    sight.pixels = all / 2;
    sight.pixelsPer /= 2;
    if (!m_isSlow || all.width() * all.height() <= kEasy || !bindBuffer(m_coarse, sight.pixels, 0))
        return drawScene(scene.sight, scene.background);
    auto* gl = context()->functions();
    gl->glViewport(0, 0, sight.pixels.width(), sight.pixels.height());
    drawScene(sight, scene.background);
    QOpenGLFramebufferObject::bindDefault();
    gl->glViewport(0, 0, all.width(), all.height());
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, QRect(QPoint(), all), m_coarse.get(),
                                              QRect(QPoint(), sight.pixels), GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

/// Reuses the last drawing if only marks have changed.
void VolumeView::paintGL() {
    if (!m_ready) {
        QPainter(this).drawText(rect(), Qt::AlignCenter, obstacle());
        return;
    }
    const Scene now = scene();
    if (m_painted && now.isServedBy(*m_painted) && !m_solid.isStale()) return;
    m_painted = now;
    QElapsedTimer clock;
    clock.start();
    now.coarse ? drawCoarsely(now) : drawFinely(now);
    if (m_solid.isSoftware()) context()->functions()->glFinish();
    m_times.draw = static_cast<double>(clock.nsecsElapsed()) * 1e-6 - m_times.prepare;
    if (now.coarse) m_isSlow = m_times.draw > (m_isSlow ? kQuickEnough : kSlow);
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
    m_navigation.move(*event, m_camera, size());
    if (!m_navigation.isGoingOn()) return;
    hurry();
    emit cameraChanged();
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
    const bool click = m_navigation.isClick(*event);
    const SolidHit hit = click ? pick(event->position()) : SolidHit{};
    const bool pivots = event->button() == Qt::MiddleButton || m_navigation.drag() == Navigation::Drag::Orbit;
    if (click && pivots && event->button() != Qt::LeftButton && hit.cell >= 0) m_camera.setPivot(hit.point);
    m_navigation.end();
    update();
}

void VolumeView::wheelEvent(QWheelEvent* event) {
    m_camera.zoom(std::exp(event->angleDelta().y() / 120.0 * 0.16), pixelOf(event->position()), size());
    hurry();
    emit cameraChanged();
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
    using Axis = Camera::Axis;
    static const std::map<int, std::array<Axis, 2>> kAxes = {{Qt::Key_1, {Axis::Front, Axis::Back}},
                                                             {Qt::Key_3, {Axis::Right, Axis::Left}},
                                                             {Qt::Key_7, {Axis::Top, Axis::Bottom}},
                                                             {Qt::Key_0, {Axis::Isometric, Axis::Isometric}}};
    if (const auto axes = kAxes.find(event->key()); axes != kAxes.end())
        look(axes->second[event->modifiers() & Qt::ControlModifier ? 1 : 0]);
    else if (event->key() == Qt::Key_5)
        setOrthographic(!m_camera.orthographic());
    else if (event->key() == Qt::Key_F)
        fit();
    else
        QOpenGLWidget::keyPressEvent(event);
}

// --- The view of a solid as a picture of any size ---

/// Draws a part of the picture, with the projection scaled so that the part fills the tile.
QImage VolumeView::tile(const QRect& part, const QSize& whole, const QColor& background) {
    std::unique_ptr<QOpenGLFramebufferObject> buffer;
    if (!bindBuffer(buffer, part.size(), kSamples)) return {};
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
    const QImage image = buffer->toImage();
    buffer->release();
    return image;
}

QString VolumeView::obstacle() const {
    return m_ready ? QString() : tr("The solid cannot be drawn: %1").arg(m_solid.error());
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
