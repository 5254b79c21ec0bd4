#include "app/views/canvas/canvas.h"

#include <QLocale>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/engine/shape/shape.h"
#include "app/project/domain.h"
#include "app/session/shape_session.h"
#include "app/style/smooth_map.h"
#include "app/tools/picture_marks.h"
#include "app/views/shape/shape_painter.h"

namespace wend {

namespace {

constexpr double kFitMargin = 36;
// fraction of the shape's size within which a visible point is the place itself
constexpr double kSamePlace = 1e-3;
constexpr int kMarksEvery = 20;       // without a frame
constexpr double kSeenBeyond = 0.01;  // of the picture

/// Returns which cells belong to hidden or locked parts; nothing if there are none.
std::vector<bool> untouchable(const std::vector<PicturePart>& parts, const SimplicialMesh<2>& rest) {
    std::vector<bool> cells;
    for (const MeshPart& range : rest.parts) {
        const auto part = std::ranges::find(parts, range.name, &PicturePart::name);
        if (part == parts.end() || !(part->hidden || part->locked)) continue;
        cells.resize(rest.cells.size());
        std::fill(cells.begin() + range.firstCell, cells.begin() + range.endCell, true);
    }
    return cells;
}

}  // namespace

ShapeCanvas::ShapeCanvas(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_viewport(*this, *this, *this, *this),
      m_shape(m_viewport, m_view) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(320, 240);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Canvas"));
    setAccessibleDescription(tr("The picture with its pins"));
    connect(&m_shape, &DrawnShape::prepared, this, &ShapeCanvas::showLooks);
    connect(&m_session.document(), &Document::opened, this, &ShapeCanvas::takeOpened);
    connect(&m_session.motion(), &ShapeMotion::frameChanged, this, &ShapeCanvas::takeFrame);
    connect(&m_session.gestures(), &ShapeGesture::pinsChanged, this, &ShapeCanvas::redraw);
    connect(&m_session.document(), &Document::projectChanged, this, [this] { m_preview.takeProject(); });
}

/// Returns the visible one of overlapping cells.
std::optional<Touch> ShapeCanvas::touch(const QPointF& widget) const {
    const auto frame = m_session.motion().frame<2>();
    if (!frame) return {};
    const Vec2 p = toShape(widget);
    const std::vector<float>& depth = *m_shape.depths();
    const std::vector<bool> closed = untouchable(m_session.document().domain().parts, *frame->rest);
    std::optional<Touch> best;
    for (int c = 0; c < frame->rest->cellCount(); ++c) {
        if (!closed.empty() && closed[static_cast<std::size_t>(c)]) continue;
        const Cell<2>& cell = frame->rest->cells[static_cast<std::size_t>(c)];
        const Vec2 a = frame->pose.col(cell[0]), u = frame->pose.col(cell[1]) - a,
                   v = frame->pose.col(cell[2]) - a, w = p - a;
        const double area = u.x() * v.y() - u.y() * v.x();
        const Vec2 by((w.x() * v.y() - w.y() * v.x()) / area, (u.x() * w.y() - u.y() * w.x()) / area);
        if (!(by.minCoeff() >= 0 && by.sum() <= 1)) continue;
        const bool isBelow =
            best && !depth.empty() &&
            depth[static_cast<std::size_t>(c)] < depth[static_cast<std::size_t>(best->place.cell)];
        if (!isBelow) best = Touch{{c, {1 - by.sum(), by.x(), by.y(), 0}}, inSpace(p)};
    }
    return best;
}

/// Returns whether another place of the rest shape is visible where this one is in the frame: a pin may be
/// dragged ahead of it.
bool ShapeCanvas::isHidden(const Place& place, const Vec3&) const {
    const FramePtr frame = m_session.motion().frame();
    const auto seen = frame ? touch(onScreen(frame->at(place))) : std::nullopt;
    return seen && (frame->restAt(seen->place) - frame->restAt(place)).norm() > kSamePlace * frame->diagonal;
}

FramePtr ShapeCanvas::shownFrame() const {
    return m_preview.over(m_session.motion().frame<2>());
}

std::vector<VertexMark> ShapeCanvas::marksOf(const std::vector<int>& vertices) const {
    const FramePtr frame = m_session.motion().frame();
    std::vector<VertexMark> marks;
    for (const int v : vertices)
        if (frame && v < frame->vertices) marks.push_back({frame->vertex(v), false});
    return marks;
}

void ShapeCanvas::showMaterial(const FramePtr& painted, bool lasts) {
    m_preview.set(m_session.motion().frame<2>(), posed<2>(painted), lasts);
    showLooks();
}

void ShapeCanvas::takeOpened() {
    m_shape.takeOpened();
    m_view.setPointsUp(!m_session.document().picture());
    fitTo(Fitted::Picture);
    update();
}

QRectF ShapeCanvas::frameRect() const {
    if (const auto& picture = m_session.document().picture())
        return {0, 0, double(picture->width), double(picture->height)};
    const auto frame = m_session.motion().frame<2>();
    return frame ? boxOf(frame->rest->points) : QRectF();
}

/// Includes a shape that was bent beyond its picture, without the mesh's margin.
QRectF ShapeCanvas::fittedRect() const {
    const QRectF rest = frameRect();
    const auto frame = m_session.motion().frame<2>();
    if (!frame || rest.isEmpty()) return rest;
    const QRectF pose = boxOf(frame->pose);
    const double x = kSeenBeyond * rest.width(), y = kSeenBeyond * rest.height();
    return rest.adjusted(-x, -y, x, y).contains(pose) ? rest : rest.united(pose);
}

/// In a mesh with a picture y points down if its coordinates are pixels.
void ShapeCanvas::takeFrame() {
    const auto frame = m_session.motion().frame<2>();
    const bool first = !m_shape.drawn() && !m_session.document().picture() && frame;
    if (first && frame->built->texture) {
        const Mat2& A = frame->built->texture->toPixels.A;
        m_view.setPointsUp(A(0, 0) * A(1, 1) < A(0, 1) * A(1, 0));
    }
    if (frame) m_shape.takeFrame(*frame);
    m_viewport.takeFrame();
    if (first) fitTo(Fitted::Picture);
    showLooks();
}

void ShapeCanvas::showLooks() {
    m_viewport.showLegendLock();
    m_shape.render();
    redraw();
}

void ShapeCanvas::redraw() {
    m_viewport.redraw(kMarksEvery);
}

void ShapeCanvas::fitTo(Fitted what) {
    m_fitted = what;
    const QRectF frame = frameRect();
    if (frame.isEmpty()) return;
    const double natural =
        m_session.document().picture() ? 1 : 1000 / std::hypot(frame.width(), frame.height());
    m_view.setZoomLimits(0.005 * natural, 64 * natural);
    fitView();
}

/// Fits the original picture if a new one was opened: the shape may be about to change.
void ShapeCanvas::fitView() {
    m_view.fit(m_fitted == Fitted::Pose ? fittedRect() : frameRect(), size(), kFitMargin);
    showView();
}

void ShapeCanvas::showView() {
    showLooks();
    emit viewChanged();
}

void ShapeCanvas::zoomTo(double zoom, const QPointF& at) {
    m_fitted = Fitted::No;
    m_view.setZoom(zoom, at);
    showView();
}

void ShapeCanvas::showPlace(const Vec3& at) {
    m_fitted = Fitted::No;
    m_view.pan(QPointF(rect().center()) - onScreen(at));
    showView();
}

void ShapeCanvas::setFaults(const std::shared_ptr<const PoseFaults<2>>& faults) {
    m_faults = faults;
    if (m_viewport.looks().map) update();
}

void ShapeCanvas::takeView(const ShapeCanvas& other) {
    m_fitted = other.m_fitted;
    if (std::exchange(m_view, other.m_view) != other.m_view) showLooks();
}

void ShapeCanvas::setDetailRegions(const std::vector<SoftRegion>& regions) {
    m_detailRegions.setRegions(regions), update();
}

void ShapeCanvas::setDepthRegions(const std::vector<SoftRegion>& regions) {
    m_depthRegions.setRegions(regions), update();
}

void ShapeCanvas::navigate(QMouseEvent& event, bool pans) {
    if (event.type() == QEvent::MouseMove) {
        m_fitted = Fitted::No;
        m_view.pan(event.position() - m_lastPan);
        showView();
    }
    if (event.type() == QEvent::MouseButtonRelease) m_panning = false;
    if (event.type() == QEvent::MouseButtonPress) m_panning = pans || navigatesBy(event);
    m_lastPan = event.position();
}

QString ShapeCanvas::pointerText(const QPointF& at) {
    if (!m_session.motion().frame()) return {};
    const QLocale locale;
    const Vec2 p = toShape(at);
    return QStringLiteral("%1, %2").arg(locale.toString(p.x(), 'f', 1), locale.toString(p.y(), 'f', 1));
}

void ShapeCanvas::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps == 0) return;
    zoomTo(m_view.zoom() * std::pow(1.2, steps), event->position());
    event->accept();
}

void ShapeCanvas::resizeEvent(QResizeEvent*) {
    const bool fits = m_fitted != Fitted::No && !m_follows && !frameRect().isEmpty();
    fits ? fitView() : showLooks();
}

// --- Drawing ---

/// Pins are hidden during playback.
void ShapeCanvas::paintOver(QPainter& painter) {
    const auto frame = m_session.motion().frame<2>();
    const Looks& looks = m_viewport.looks();
    if (looks.hidden || !frame) return;
    const Theme theme = m_viewport.theme();
    const Measure measure = looks.colours.measure;
    ShapePainter over(painter, *this, theme);
    if (looks.map && isDistortion(measure)) over.worst(*frame, measure);
    if (looks.map && m_faults && !looks.rest && !looks.standIn)
        paintFaults(painter, *this, *frame, *m_faults);
    if (looks.marks || (looks.map && measure == Measure::Stiffness))
        paintStiffnessMarks(painter, *this, size());
    if (looks.arrows) paintVelocityArrows(painter, *this, m_session.motion().velocity(), size());
    m_layer.setLayer(looks.layer);
    m_layer.paint(painter, *this);
    m_detailRegions.paint(painter, *this);
    m_depthRegions.paint(painter, *this);
    m_onion.paintOutlines(painter, *this);
    if (!looks.rest && !m_session.playback().isPlaying()) over.joints(*frame);
    m_viewport.paintPins(over);
    if (Tool* tool = m_viewport.tool(); tool && !m_session.playback().isPlaying()) tool->paint(painter);
    m_viewport.paintLegend(painter, size());
}

void ShapeCanvas::paintEvent(QPaintEvent*) {
    m_viewport.marksPainted();
    QPainter painter(this);
    const Looks& looks = m_viewport.looks();
    const Theme theme = m_shape.theme();
    Ground::Look look{m_view, size(), devicePixelRatioF(), {}, looks.backdrop, theme.dark, theme.checkerA};
    if (m_session.document().picture()) look.paper = frameRect();
    m_ground.paint(painter, look, theme, m_session.motion().isDragging() || m_session.playback().isPlaying());
    m_onion.setShown(looks.onionSkin);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!looks.hidden) m_onion.paintFills(painter, *this);
    if (theme.dark && m_shape.showsMap() && !isPainted(looks.colours.measure))
        m_onion.paintRim(painter, *this,
                         *m_shape.frame());  // the dark end of a map is as dark as the ground
    painter.setRenderHint(QPainter::Antialiasing, false);
    m_shape.paint(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOver(painter);
}

}  // namespace wend
