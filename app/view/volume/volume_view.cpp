#include "app/view/volume/volume_view.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "app/view/volume/ray_casting.h"

namespace wend {
namespace {

constexpr double kRadiansPerPixel = 0.008;
constexpr double kClickPixels = 4;
constexpr int kSamples = 4;
const QRgb kPlainColour = qRgb(196, 178, 150);

}  // namespace

VolumeView::VolumeView(QWidget* parent) : QOpenGLWidget(parent) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(kSamples);
    setFormat(format);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("View of the solid"));
    m_camera.look(Camera::Axis::Isometric);
}

VolumeView::~VolumeView() {
    makeCurrent();
    m_renderer.release();
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
    const bool sameSurface = m_cut == CutKind::None && picture.facets == m_picture.facets;
    m_picture = std::move(picture);
    if (m_picture.vertexColours.empty() && m_picture.cellColours.empty())
        m_picture.vertexColours.assign(static_cast<std::size_t>(m_picture.pose.cols()), kPlainColour);
    m_stale = true;
    if (!sameSurface) remakeSurface();
    update();
    if (fitView) fit();
}

void VolumeView::setStyle(const SurfaceStyle& style) {
    m_style = style;
    update();
}

void VolumeView::setCut(CutKind kind, const CutPlane& plane) {
    m_cut = kind;
    m_plane = plane;
    remakeSurface();
}

void VolumeView::fit() {
    if (m_picture.pose.cols() == 0) return;
    m_camera.fit(m_picture.pose, size());
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

void VolumeView::remakeSurface() {
    if (!m_picture.rest) return;
    switch (m_cut) {
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
    m_stale = true;
    update();
}

SolidHit VolumeView::pick(const QPointF& pixel) const {
    return nearestHit(m_surface, m_picture.pose, m_camera.ray(pixelOf(pixel), size()));
}

std::vector<int> VolumeView::verticesIn(const QRectF& rectangle, bool visibleOnly) const {
    std::vector<int> found;
    for (Eigen::Index v = 0; v < m_picture.pose.cols(); ++v) {
        const Vec<3> screen = m_camera.project(m_picture.pose.col(v), size());
        if (std::abs(screen.z()) <= 1 && rectangle.contains(screen.x(), screen.y()))
            found.push_back(static_cast<int>(v));
    }
    if (visibleOnly) keepVisible(found, m_surface, m_picture.pose, m_camera, size());
    return found;
}

void VolumeView::initializeGL() {
    m_ready = m_renderer.initialize();
}

void VolumeView::resizeGL(int, int) {}

void VolumeView::uploadIfStale() {
    if (!m_stale) return;
    m_renderer.upload(m_surface, m_picture.pose, m_picture.vertexColours, m_picture.cellColours);
    m_stale = false;
}

void VolumeView::setGlyphs(std::vector<DrawVertex> triangles) {
    if (triangles.empty() && m_glyphs.empty()) return;
    m_glyphs = std::move(triangles);
    m_glyphsStale = true;
    update();
}

void VolumeView::drawScene(const QSize& size, const QColor& background) {
    auto* gl = context()->functions();
    gl->glClearColor(background.redF(), background.greenF(), background.blueF(), background.alphaF());
    gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (!m_picture.rest) return;
    uploadIfStale();
    if (m_glyphsStale) m_renderer.uploadGlyphs(m_glyphs);
    m_glyphsStale = false;
    m_renderer.draw(m_camera.view(), m_camera.projection(size), m_camera.orthographic(), m_style);
}

void VolumeView::paintGL() {
    if (m_ready) {
        drawScene(size(),
                  m_background.isValid() ? m_background : palette().color(QPalette::Base).darker(104));
        return;
    }
    QPainter(this).drawText(rect(), Qt::AlignCenter,
                            tr("The solid cannot be drawn: %1").arg(m_renderer.error()));
}

QImage VolumeView::picture(const QSize& size, bool transparent) {
    makeCurrent();
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(kSamples);
    QOpenGLFramebufferObject buffer(size, format);
    QImage image;
    if (m_ready && buffer.isValid() && buffer.bind()) {
        context()->functions()->glViewport(0, 0, size.width(), size.height());
        drawScene(size, transparent ? QColor(0, 0, 0, 0) : m_background);
        image = buffer.toImage();
        buffer.release();
    }
    doneCurrent();
    update();
    return image;
}

VolumeView::Drag VolumeView::dragFor(const QMouseEvent& event) const {
    const bool shift = event.modifiers() & Qt::ShiftModifier,
               control = event.modifiers() & Qt::ControlModifier, alt = event.modifiers() & Qt::AltModifier;
    const auto button = event.button();
    if (m_preset == NavigationPreset::VtkLike) {
        if (button == Qt::LeftButton) return shift ? Drag::Pan : Drag::Orbit;
        if (button == Qt::MiddleButton) return Drag::Pan;
        return button == Qt::RightButton ? Drag::Zoom : Drag::None;
    }
    const bool right = m_preset == NavigationPreset::Wend && button == Qt::RightButton;
    // Alt and the left button stand in for a middle one that is missing.
    if (button != Qt::MiddleButton && !right && !(alt && button == Qt::LeftButton)) return Drag::None;
    if (shift) return Drag::Pan;
    return control ? Drag::Zoom : Drag::Orbit;
}

void VolumeView::mousePressEvent(QMouseEvent* event) {
    m_last = m_pressed = event->position();
    m_drag = dragFor(*event);
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF step = event->position() - m_last;
    m_last = event->position();
    if (m_drag == Drag::Orbit)
        m_camera.orbit(step.x() * kRadiansPerPixel, step.y() * kRadiansPerPixel);
    else if (m_drag == Drag::Pan)
        m_camera.pan(step.x(), step.y(), size());
    else if (m_drag == Drag::Zoom)
        m_camera.zoom(std::exp(-0.01 * step.y()), pixelOf(rect().center()), size());
    else if (event->buttons() == Qt::NoButton)
        emit hovered(pick(event->position()));
    if (m_drag == Drag::None) return;
    update();
    emit cameraChanged();
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
    const bool click = (event->position() - m_pressed).manhattanLength() <= kClickPixels;
    const SolidHit hit = click ? pick(event->position()) : SolidHit{};
    if (click && event->button() == Qt::LeftButton) emit picked(hit, event->modifiers());
    const bool pivots = event->button() == Qt::MiddleButton || m_drag == Drag::Orbit;
    if (click && pivots && event->button() != Qt::LeftButton && hit.cell >= 0) m_camera.setPivot(hit.point);
    m_drag = Drag::None;
    update();
}

void VolumeView::wheelEvent(QWheelEvent* event) {
    m_camera.zoom(std::exp(event->angleDelta().y() / 120.0 * 0.16), pixelOf(event->position()), size());
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

}  // namespace wend
