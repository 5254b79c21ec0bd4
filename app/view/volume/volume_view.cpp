#include "app/view/volume/volume_view.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

#include "app/view/volume/ray_casting.h"

namespace wend {
namespace {

constexpr double kRadiansPerPixel = 0.008;
constexpr double kClickPixels = 4;
const QRgb kPlainColour = qRgb(196, 178, 150);

}  // namespace

VolumeView::VolumeView(QWidget* parent) : QOpenGLWidget(parent) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
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
    m_picture = std::move(picture);
    if (m_picture.vertexColours.empty() && m_picture.cellColours.empty())
        m_picture.vertexColours.assign(static_cast<std::size_t>(m_picture.pose.cols()), kPlainColour);
    remakeSurface();
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
    m_camera.fit(m_picture.pose.rowwise().minCoeff(), m_picture.pose.rowwise().maxCoeff());
    update();
}

void VolumeView::look(Camera::Axis axis) {
    m_camera.look(axis);
    update();
}

void VolumeView::setOrthographic(bool on) {
    m_camera.setOrthographic(on);
    update();
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

VolumeHit VolumeView::pick(const QPointF& pixel) const {
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

void VolumeView::paintGL() {
    auto* gl = context()->functions();
    const QColor back = palette().color(QPalette::Base).darker(104);
    gl->glClearColor(back.redF(), back.greenF(), back.blueF(), 1);
    gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (!m_ready) {
        QPainter(this).drawText(rect(), Qt::AlignCenter,
                                tr("The solid cannot be drawn: %1").arg(m_renderer.error()));
        return;
    }
    if (!m_picture.rest) return;
    uploadIfStale();
    m_renderer.draw(m_camera.view(), m_camera.projection(size()), m_camera.orthographic(), m_style);
}

VolumeView::Drag VolumeView::dragFor(const QMouseEvent& event) const {
    const bool shift = event.modifiers() & Qt::ShiftModifier,
               control = event.modifiers() & Qt::ControlModifier;
    const auto button = event.button();
    if (m_preset == NavigationPreset::VtkLike) {
        if (button == Qt::LeftButton) return shift ? Drag::Pan : Drag::Orbit;
        if (button == Qt::MiddleButton) return Drag::Pan;
        return button == Qt::RightButton ? Drag::Zoom : Drag::None;
    }
    if (button != Qt::MiddleButton) return Drag::None;
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
    if (m_drag != Drag::None) update();
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
    const bool click = (event->position() - m_pressed).manhattanLength() <= kClickPixels;
    const VolumeHit hit = click ? pick(event->position()) : VolumeHit{};
    if (click && event->button() == Qt::LeftButton) emit picked(hit, event->modifiers());
    if (click && event->button() == Qt::MiddleButton && hit.cell >= 0) m_camera.setPivot(hit.point);
    m_drag = Drag::None;
    update();
}

void VolumeView::wheelEvent(QWheelEvent* event) {
    m_camera.zoom(std::exp(event->angleDelta().y() / 120.0 * 0.16), pixelOf(event->position()), size());
    update();
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
