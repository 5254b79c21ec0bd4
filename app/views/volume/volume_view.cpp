#include "app/views/volume/volume_view.h"

#include <Eigen/Geometry>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>
#include <map>

#include "app/views/volume/glyphs.h"
#include "app/views/volume/volume_picture.h"

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

constexpr int kPictureSamples = 4;

void putTile(QImage& image, const QPoint& at, const QImage& tile) {
    QPainter painter(&image);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(at, tile);
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

void VolumeView::mousePressEvent(QMouseEvent* event) {
    m_navigation.press(*event);
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
    m_navigation.move(*event, m_camera, size());
    if (!m_navigation.isGoingOn()) return;
    hurry();
    update();
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
    update();
    emit cameraChanged();
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
    const bool opposite = event->modifiers() & Qt::ControlModifier;
    using Axis = Camera::Axis;
    switch (event->key()) {
        case Qt::Key_1:
            look(opposite ? Axis::Back : Axis::Front);
            break;
        case Qt::Key_3:
            look(opposite ? Axis::Left : Axis::Right);
            break;
        case Qt::Key_7:
            look(opposite ? Axis::Bottom : Axis::Top);
            break;
        case Qt::Key_5:
            setOrthographic(!m_camera.orthographic());
            break;
        case Qt::Key_0:
            look(Axis::Isometric);
            break;
        case Qt::Key_F:
            fit();
            break;
        default:
            QOpenGLWidget::keyPressEvent(event);
    }
}

// --- The view of a solid as a picture of any size ---

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

// --- Uploads changed data to the GPU ---

void VolumeView::upload() {
    if (m_meshStale) uploadMeshes();
    if (m_style.flat == m_hasNormals) m_poseStale = true;
    if (m_poseStale) uploadPose();
    if (m_coloursStale) uploadColours();
    if (m_texturesStale) uploadTextures();
    if (m_glyphsStale) uploadGlyphs();
    m_meshStale = m_poseStale = m_coloursStale = m_texturesStale = m_glyphsStale = false;
}

/// Textures are kept while their skin is hidden, because reading them takes time.
void VolumeView::uploadTextures() {
    if (!m_picture.skin) return;
    QStringList unread;
    m_renderer.setTextures(texturesOf(m_picture.skin.get(), &unread));
    m_textured = m_picture.skin;
    if (!unread.isEmpty()) emit picturesMissing(unread);
}

/// The section of a cut detailed surface is that of the solid.
void VolumeView::uploadMeshes() {
    const Points<3>& rest = m_picture.rest->points.cols() > 0 ? m_picture.rest->points : m_picture.pose;
    const bool exact = m_cut == CutKind::Exact;
    if (showsSkin())
        m_outer = drawMesh(*m_picture.skin, *m_picture.embedding);
    else
        m_outer = drawMesh(exact ? partOf(m_surface, false) : m_surface, rest);
    m_section = exact ? drawSection(partOf(m_surface, true)) : DrawMesh();
    m_outline = borderOf(m_section.triangles);
    m_renderer.setMesh(SurfaceRenderer::Outer, m_outer);
    m_renderer.setMesh(SurfaceRenderer::Section, m_section);
    m_hasContour = false;
    m_drawnTriangles = static_cast<int>(m_outer.triangles.size() + m_section.triangles.size());
    m_poseStale = m_coloursStale = true;
}

void VolumeView::uploadPose() {
    m_hasNormals = !m_style.flat;
    Points<3> outer = showsSkin() ? skinPose() : drawnPoints(m_outer, m_picture.pose);
    m_renderer.setPose(SurfaceRenderer::Outer, m_outer, outer, m_hasNormals);
    m_contour.takePoints(std::move(outer));
    const Points<3> section = drawnPoints(m_section, m_picture.pose);
    m_renderer.setPose(SurfaceRenderer::Section, m_section, section, true);
    Points<3> ends(3, static_cast<Eigen::Index>(2 * m_outline.size()));
    Eigen::Index next = 0;
    for (const auto& edge : m_outline)
        for (const int point : edge) ends.col(next++) = section.col(point);
    m_renderer.setOutline(ends);
    m_sectionEnds = std::move(ends);
    m_glyphsStale = true;
}

/// Makes the rim for the current view, including the border of a section.
void VolumeView::uploadRim(const Sight& sight) {
    if (!std::exchange(m_hasContour, true)) m_contour.takeTriangles(m_outer.triangles);
    const bool clips = showsSkin() && m_cut == CutKind::Exact;
    const Points<3> contour =
        m_contour.ends(sight.view, sight.orthographic, clips ? std::optional(m_plane) : std::nullopt);
    Points<3> ends(3, contour.cols() + m_sectionEnds.cols());
    ends << contour, m_sectionEnds;
    m_renderer.setRim(ends);
}

std::vector<QRgb> VolumeView::coloursOf(const DrawMesh& mesh, bool skin) const {
    if (skin && m_picture.materials && !mesh.colours.empty()) return mesh.colours;
    std::vector<QRgb> colours;
    colours.reserve(mesh.cells.size());
    for (const int c : mesh.cells) colours.push_back(m_picture.cellColours[c]);
    return colours;
}

void VolumeView::uploadColours() {
    m_renderer.setColours(SurfaceRenderer::Outer, coloursOf(m_outer, showsSkin()));
    if (m_style.mapOpacity > 0) m_renderer.setMap(SurfaceRenderer::Outer, coloursOf(m_outer, false));
    m_renderer.setColours(SurfaceRenderer::Section,
                          m_picture.section
                              ? std::vector<QRgb>(m_section.triangles.size(), *m_picture.section)
                              : coloursOf(m_section, false));
    m_renderer.setRamp(m_picture.ramp);
    m_renderer.setPaint(m_picture.paint.opacity);
    uploadPlaces(SurfaceRenderer::Outer, m_outer, showsSkin());
    uploadPlaces(SurfaceRenderer::Section, m_section, false);
}

/// Interpolates linearly within the cells, so that a section matches the surface. A surface may extend beyond
/// its cells, where linear values exceed the bounds of paint.
void VolumeView::uploadPlaces(SurfaceRenderer::Layer layer, const DrawMesh& mesh, bool skin) {
    const SolidPaint& paint = m_picture.paint;
    const bool isPainted = paint.opacity > 0;
    const auto onPoints = [&](const Points<3>& values) {
        return skin ? m_picture.embedding->interpolate(*m_picture.rest, values) : drawnPoints(mesh, values);
    };
    std::vector<SurfaceRenderer::Place> places;
    if (isPainted || m_picture.places.cols() > 0) {
        const Points<3> ofPoints = onPoints(isPainted ? paint.colours : m_picture.places);
        const Points<3> opacities =
            isPainted ? onPoints(paint.opacities) : Points<3>::Zero(3, ofPoints.cols());
        for (const DrawMesh::Vertex& vertex : mesh.vertices) {
            Eigen::Vector4f place;
            place << ofPoints.col(vertex.point).cast<float>(), static_cast<float>(opacities(0, vertex.point));
            if (isPainted) place = place.cwiseMax(0).cwiseMin(1).eval();
            places.push_back({place.x(), place.y(), place.z(), place.w()});
        }
    }
    m_renderer.setPlaces(layer, places);
    if (!isPainted) return;
    std::vector<QRgb> own;
    for (const int c : mesh.cells) own.push_back(paint.own[c]);
    m_renderer.setMap(layer, own);
}

/// Uploads the glyphs. Marked triangles of one colour form a kind.
void VolumeView::uploadGlyphs() {
    m_renderer.setGlyphs(m_glyphs);
    m_renderer.setVeiled(m_veiled);
    std::map<QRgb, std::vector<DrawVertex>> marked;
    for (const int f : m_picture.marked) {
        const Facet<3>& facet = (*m_picture.facets)[static_cast<std::size_t>(f)];
        const Vec<3> a = m_picture.pose.col(facet.vertices[0]);
        const Vec<3> b = m_picture.pose.col(facet.vertices[1]), c = m_picture.pose.col(facet.vertices[2]);
        const Vec<3> normal = (b - a).cross(c - a).stableNormalized();
        const QRgb colour = m_picture.cellColours[facet.cells[0]];
        for (const Vec<3>& corner : {a, b, c}) marked[colour].push_back(drawVertex(corner, normal, colour));
    }
    std::vector<std::vector<DrawVertex>> kinds;
    for (auto& [colour, triangles] : marked) kinds.push_back(std::move(triangles));
    m_renderer.setMarked(kinds);
}

}  // namespace wend
