#include "app/views/volume/volume_view.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

namespace wend {
namespace {

constexpr int kViewSamples = 4;
constexpr double kSlow = 16, kQuickEnough = 3;  // milliseconds of a drawing by the processor
constexpr int kEasy = 600'000;                  // pixels that are always drawn
constexpr int kRestAfter = 160;                 // milliseconds without motion
constexpr double kOwnFromBehind = 0.7;          // saturation of back faces, distinguishable from the front
const QRgb kPlainColour = qRgb(196, 178, 150);

/// Compares points, because Eigen compares matrices of one size only.
bool isSame(const Points<3>& a, const Points<3>& b) {
    return a.cols() == b.cols() && a == b;
}

}  // namespace

VolumeView::VolumeView(QWidget* parent) : QOpenGLWidget(parent) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
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
    m_camera.look(Camera::Axis::Isometric);
}

VolumeView::~VolumeView() {
    if (context()) disconnect(context(), nullptr, this, nullptr);
    releaseGl();
}

void VolumeView::releaseGl() {
    makeCurrent();
    m_renderer.release();
    m_fine.reset();
    m_coarse.reset();
    m_textured.reset();
    m_ready = false;
    doneCurrent();
}

bool VolumeView::available() {
    QOpenGLContext context;
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    context.setFormat(format);
    return context.create() && context.format().version() >= qMakePair(3, 3);
}

void VolumeView::setPicture(VolumePicture picture, bool fitView) {
    const bool sameSurface = m_cut == CutKind::None && picture.facets == m_picture.facets &&
                             picture.embedding == m_picture.embedding;
    if (picture.cellColours.empty() && picture.rest)
        picture.cellColours.assign(picture.facets->size(), kPlainColour);  // more than there are cells
    const bool samePose = isSame(picture.pose, m_picture.pose);
    if (picture.skin != m_picture.skin || picture.rest != m_picture.rest) m_skinRays.takeSkin();
    if (picture.skin != m_picture.skin || !samePose) m_ridden.reset();
    if (picture.skin != m_picture.skin) m_meshStale = true;
    if (picture.skin && picture.skin != m_textured) m_texturesStale = true;
    m_coloursStale = m_coloursStale || picture.cellColours != m_picture.cellColours ||
                     picture.section != m_picture.section || picture.materials != m_picture.materials ||
                     !isSame(picture.places, m_picture.places) || picture.ramp != m_picture.ramp ||
                     picture.paint != m_picture.paint;
    m_glyphsStale = m_glyphsStale || !picture.marked.empty() || !m_picture.marked.empty();
    if (!samePose) {
        m_poseStale = true;
        m_rays.takePose();
        m_skinRays.takePose();
    }
    m_picture = std::move(picture);
    if (!sameSurface) remakeSurface();
    update();
    if (fitView) fit();
}

void VolumeView::setStyle(const SurfaceStyle& style) {
    m_coloursStale = m_coloursStale || (style.mapOpacity > 0) != (m_style.mapOpacity > 0);
    m_style = style;
    update();
}

void VolumeView::setCut(CutKind kind, const CutPlane& plane) {
    m_cut = kind;
    m_plane = plane;
    remakeSurface();
}

/// A surface embedded in the solid hides it, unless a section is filled with its cells.
Points<3> VolumeView::fitted() const {
    const Points<3> none(3, 0);
    const Points<3>& skin = showsSkin() ? skinPose() : none;
    const Points<3>& solid = showsSkin() && m_cut == CutKind::None ? none : m_picture.pose;
    Points<3> all(3, skin.cols() + solid.cols() + static_cast<Eigen::Index>(m_glyphs.size()));
    all.leftCols(skin.cols()) = skin;
    all.middleCols(skin.cols(), solid.cols()) = solid;
    Eigen::Index next = skin.cols() + solid.cols();
    for (const DrawVertex& vertex : m_glyphs)
        all.col(next++) = Vec<3>(vertex.position[0], vertex.position[1], vertex.position[2]);
    return all;
}

void VolumeView::fit() {
    if (m_picture.pose.cols() == 0) return;
    m_camera.fit(fitted(), size());
    const Points<3>& pose = m_picture.pose;
    m_camera.setPivot((pose.rowwise().minCoeff() + pose.rowwise().maxCoeff()) / 2);
    update();
    emit cameraChanged();
}

void VolumeView::look(Camera::Axis axis) {
    m_camera.look(axis);
    update();
    emit cameraChanged();
}

void VolumeView::setOrthographic(bool on) {
    m_camera.setOrthographic(on);
    update();
    emit cameraChanged();
}

/// A surface without tetrahedra has no inside that a cut could show.
void VolumeView::remakeSurface() {
    if (!m_picture.rest) return;
    switch (m_picture.rest->cells.empty() ? CutKind::None : m_cut) {
        case CutKind::None:
            m_surface = wholeSurface(*m_picture.facets);
            break;
        case CutKind::WholeCells:
            m_surface = wholeCellCut(*m_picture.rest, *m_picture.facets, m_picture.pose, m_plane);
            break;
        case CutKind::Exact:
            m_surface = exactCut(*m_picture.rest, *m_picture.facets, m_picture.pose, m_plane);
            break;
    }
    m_meshStale = true;
    m_rays.takeSurface(ridesInside() ? partOf(m_surface, true) : m_surface);
    update();
}

const Points<3>& VolumeView::skinPose() const {
    if (!m_ridden) m_ridden = m_picture.embedding->carry(*m_picture.rest, m_picture.pose);
    return *m_ridden;
}

/// Returns the hit of the visible part of the skin, or of the section behind the cut.
SolidHit VolumeView::hitOf(const Ray& ray) const {
    const SolidHit cells = m_rays.hit(ray, m_picture.pose);
    if (!ridesInside()) return cells;
    const auto cut = m_cut == CutKind::Exact ? std::optional(m_plane) : std::nullopt;
    const SolidHit skin = m_skinRays.hit(ray, m_picture, skinPose(), cut);
    const bool isSkin =
        cells.cell < 0 || (skin.point - ray.origin).norm() < (cells.point - ray.origin).norm();
    return skin.cell >= 0 && isSkin ? skin : cells;
}

SolidHit VolumeView::pick(const QPointF& pixel) const {
    return hitOf(m_camera.ray(pixelOf(pixel), size()));
}

void VolumeView::keepVisible(std::vector<int>& vertices) const {
    std::erase_if(vertices, [&](int v) {
        const Vec<3> p = m_picture.pose.col(v);
        const Ray sight = m_camera.ray(m_camera.project(p, size()).head<2>(), size());
        const SolidHit hit = hitOf(sight);
        // A vertex of the surface is met by the ray itself, up to rounding.
        return hit.cell >= 0 &&
               (hit.point - sight.origin).norm() < (p - sight.origin).dot(sight.direction) * (1 - 1e-4);
    });
}

std::vector<int> VolumeView::verticesIn(const QRectF& rectangle, bool visibleOnly) const {
    std::vector<int> found;
    for (Eigen::Index v = 0; v < m_picture.pose.cols(); ++v) {
        const Vec<3> screen = m_camera.project(m_picture.pose.col(v), size());
        if (std::abs(screen.z()) <= 1 && rectangle.contains(screen.x(), screen.y()))
            found.push_back(static_cast<int>(v));
    }
    if (visibleOnly) keepVisible(found);
    return found;
}

/// Called for every new context, such as after a change of the window, which has no resources yet.
void VolumeView::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VolumeView::releaseGl,
            static_cast<Qt::ConnectionType>(Qt::DirectConnection | Qt::UniqueConnection));
    m_ready = m_renderer.initialize();
    m_meshStale = m_poseStale = m_coloursStale = m_texturesStale = m_glyphsStale = true;
    m_painted.reset();
}

void VolumeView::resizeGL(int, int) {
    m_fine.reset();
    m_coarse.reset();
    m_painted.reset();
}

void VolumeView::hurry() {
    m_rest.start();
}

void VolumeView::setGlyphs(std::vector<DrawVertex> triangles, std::vector<DrawVertex> veiled) {
    if (triangles.empty() && m_glyphs.empty() && veiled.empty() && m_veiled.empty()) return;
    m_glyphs = std::move(triangles);
    m_veiled = std::move(veiled);
    m_glyphsStale = true;
    update();
}

void VolumeView::drawScene(const Sight& sight, const QColor& background) {
    auto* gl = context()->functions();
    gl->glClearColor(background.redF(), background.greenF(), background.blueF(), background.alphaF());
    gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (!m_picture.rest) return;
    QElapsedTimer clock;
    clock.start();
    upload();
    m_times.prepare = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    const bool clips = showsSkin() && m_cut == CutKind::Exact;
    SurfaceStyle look = style();
    if (background.alpha() < 255) look.rim = QColor();  // the background of a transparent picture is unknown
    if (look.rim.isValid()) uploadRim(sight);
    m_renderer.draw(sight, look, showsSkin() && m_picture.materials,
                    clips ? std::optional(m_plane) : std::nullopt);
}

SurfaceStyle VolumeView::style() const {
    SurfaceStyle style = m_style;
    if (m_picture.isOpen) style.ownFromBehind = kOwnFromBehind;
    return style;
}

/// Antialiased edges are slow on a CPU: they are drawn when nothing moves.
VolumeView::Scene VolumeView::scene() const {
    const Sight sight{m_camera.view(), m_camera.projection(size()), m_camera.orthographic(),
                      size() * devicePixelRatioF(), devicePixelRatioF()};
    return {sight, style(), background(), m_renderer.isSoftware() && isMoving(), m_picture.materials};
}

/// Returns whether the scene differs from the last drawing.
bool VolumeView::isStale() const {
    return m_meshStale || m_poseStale || m_coloursStale || m_texturesStale || m_glyphsStale ||
           m_style.flat == m_hasNormals;
}

bool VolumeView::isSettled() const {
    return m_painted && !m_painted->coarse && *m_painted == scene() && !isStale();
}

QColor VolumeView::background() const {
    return m_background.isValid() ? m_background : palette().color(QPalette::Base).darker(104);
}

/// Makes the buffer anew if it has another size: that of the view's buffer changes without a resize on
/// another screen. Returns false if memory is insufficient.
bool VolumeView::bind(std::unique_ptr<QOpenGLFramebufferObject>& buffer, const QSize& pixels, int samples) {
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

/// Draws with antialiased edges; with those of single pixels if memory is insufficient.
void VolumeView::drawFinely(const Scene& scene) {
    const bool isFine = bind(m_fine, scene.sight.pixels, kViewSamples);
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
    if (!m_isSlow || all.width() * all.height() <= kEasy || !bind(m_coarse, sight.pixels, 0))
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
    if (m_painted && now.isServedBy(*m_painted) && !isStale()) return;
    m_painted = now;
    QElapsedTimer clock;
    clock.start();
    now.coarse ? drawCoarsely(now) : drawFinely(now);
    if (m_renderer.isSoftware()) context()->functions()->glFinish();
    m_times.draw = static_cast<double>(clock.nsecsElapsed()) * 1e-6 - m_times.prepare;
    if (now.coarse) m_isSlow = m_times.draw > (m_isSlow ? kQuickEnough : kSlow);
}

}  // namespace wend
