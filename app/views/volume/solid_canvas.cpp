#include "app/views/volume/solid_canvas.h"

#include <QLocale>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/project/design.h"
#include "app/session/pins/pin_shapes.h"
#include "app/session/shape_session.h"
#include "app/views/volume/solid_overlay.h"

namespace wend {

namespace {

constexpr int kMarksEvery = 40, kMarksEveryInSoftware = 120;  // without a frame
constexpr double kNear = 0.2;                                 // fraction of the diagonal shown around a cell
constexpr std::size_t kMostRays = 4000;  // vertices of one handle beyond which all count as visible

/// Adds the directions of a selected curve, which may be far from it.
void addDirections(const Pin& handle, const PinPath& path, std::vector<Vec3>& points) {
    for (const PinMotion& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
        const auto at = std::lower_bound(path.times.begin(), path.times.end(), motion.start);
        if (!curve || curve->points.empty() || at == path.times.end()) continue;
        const Vec3 start = path.points[static_cast<std::size_t>(at - path.times.begin())];
        for (const Vec3& p : curve->points) points.push_back(start + p - curve->points.front());
    }
}

/// Returns the points of the pins and their paths as they are drawn.
std::vector<Vec3> pathPoints(const ShapeSession& session) {
    std::vector<Vec3> points;
    for (const PinView& view : session.gestures().pins()) points.push_back(view.centre);
    const auto& handles = session.document().design().handles;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        const auto starts = session.pins().pathStarts(h);
        if (handles[h].motions.empty() || starts.empty() || handles[h].traits.hidden) continue;
        for (const PinPath& path : pinPaths(handles[h], shownStarts(starts), 3)) {
            points.insert(points.end(), path.points.begin(), path.points.end());
            if (session.selection().contains(h)) addDirections(handles[h], path, points);
        }
    }
    return points;
}

}  // namespace

// --- The viewpoint of a solid and its storage in the project ---

bool SolidViewpoint::begin() {
    if (std::exchange(m_generation, m_document.generation()) == m_document.generation()) return false;
    m_isFitted = true;
    lookAtFirst();
    return true;
}

void SolidViewpoint::lookAtFirst() {
    m_view.camera().setUpAxis(m_document.up());
    m_view.camera().setOrthographic(false);
    m_view.look(Camera::Axis::Isometric);
}

void SolidViewpoint::restore() {
    const auto& kept = m_document.camera();
    m_asOpened.reset();
    if (!kept) return;
    m_isFitted = false;
    Camera camera = m_view.camera();
    camera.restore(*kept);
    m_asOpened = camera.saved();
    m_view.setCamera(camera);
}

void SolidViewpoint::takeUpAxis() {
    const UpAxis up = m_document.up();
    if (m_document.dimension() != 3 || !isOfDocument() || up == m_view.camera().upAxis()) return;
    m_view.camera().setUpAxis(up);
    m_view.fit();
}

void SolidViewpoint::keep() {
    const Camera& camera = m_view.camera();
    const SavedCamera now = camera.saved();
    if (!isOfDocument() || m_asOpened == now) return;
    Camera first = camera;
    first.setOrthographic(false);
    first.look(Camera::Axis::Isometric);
    const bool isTurned = now.parallel || !first.direction().isApprox(camera.direction(), 1e-6);
    if (!m_isFitted) first.fit(m_view.fitted(), m_view.size());
    const bool isKept = isTurned || (!m_isFitted && first.saved() != now);
    m_document.setCamera(isKept ? std::optional(now) : std::nullopt);
}

void SolidViewpoint::lookAlong(const Vec3& direction) {
    m_view.camera().lookAlong(direction);
    m_isFitted = true;
    m_view.fit();
}

void SolidViewpoint::zoomTo(const Points3& points) {
    m_isFitted = false;
    Camera camera = m_view.camera();
    camera.fit(points, m_view.size());
    m_view.setCamera(camera);
}

// --- The canvas ---

SolidCanvas::SolidCanvas(ShapeSession& session, QWidget* parent)
    : VolumeView(parent),
      m_session(session),
      m_cutTool(
          *this, [this](const CutPlane& plane) { setCutPlane(plane); },
          [this] { return m_viewport.tool() && m_viewport.tool()->hasManipulator(); }),
      m_overlay(new SolidOverlay(*this)),
      m_viewport(*this, *this, *this, *m_overlay, &m_cutTool),
      m_look(m_viewport),
      m_viewpoint(*this, session.document()) {
    setMinimumSize(320, 240);
    // Cancels gestures with cells and vertices of an old mesh.
    const auto takeFrame = [this] {
        const auto frame = m_session.motion().frame<3>();
        const std::shared_ptr<const void> mesh = frame ? frame->shape : nullptr;
        if (std::exchange(m_mesh, mesh) != mesh) m_viewport.cancelGesture();
        m_viewport.takeFrame();
        showLooks();
    };
    const Document& document = session.document();
    connect(&session.motion(), &ShapeMotion::frameChanged, this, takeFrame);
    connect(&session.gestures(), &ShapeGesture::pinsChanged, this, &SolidCanvas::redraw);
    connect(&document, &Document::projectChanged, this, [this] {
        m_preview.takeProject();
        m_viewpoint.takeUpAxis();
    });
    connect(&document, &Document::viewWanted, this, [this] {
        if (m_session.motion().frame<3>()) m_viewpoint.keep();
    });
    connect(this, &VolumeView::cameraChanged, this, &SolidCanvas::redraw);
    takeFrame();
}

/// Repainting composes the whole window, which is slow without a GPU.
void SolidCanvas::redraw() {
    m_viewport.redraw(solid().isSoftware() ? kMarksEveryInSoftware : kMarksEvery);
}

/// Fits the view to a new solid: first at rest, then again when its motion is known.
void SolidCanvas::showLooks() {
    m_missed = m_held;
    m_viewport.showLegendLock();
    if (m_held) return;
    setBackground(m_look.ground());
    setStyle(m_look.style());
    const auto frame = posed<3>(seen(m_viewport.looks(), shownFrame()));
    if (!frame) return setGlyphs({}, {});  // those of the last solid
    const bool isNew = m_viewpoint.begin();
    m_toFit = m_toFit || isNew;
    if (frame->live || m_session.playback().isPlaying()) hurry();
    setPicture(m_look.picture(*frame), m_toFit && m_viewpoint.isFitted());
    if (isNew) m_viewpoint.restore();
    m_toFit = m_toFit && m_session.motion().isStale();
    auto [triangles, veiled] = m_look.glyphs(*frame, solid());
    setGlyphs(std::move(triangles), std::move(veiled));
    m_overlay->update();  // with the solid: the window is put together once
}

bool SolidCanvas::isMoving() const {
    return VolumeView::isMoving() || m_session.motion().isDragging() || m_session.playback().isPlaying();
}

void SolidCanvas::setHeld(bool held) {
    m_held = held;
    if (!held && m_missed) showLooks();
}

void SolidCanvas::showPreview(const Skin& skin) {
    if (m_session.motion().frame<3>() || skin.points.cols() == 0 || !skin.points.allFinite()) return;
    m_viewpoint.lookAtFirst();
    const QRgb plain = m_look.plainColour(), colour = m_viewport.isDimmed() ? plain : dimmed(plain);
    setPicture(
        pictureOfSurface(skin.points, skin.triangles, std::vector<QRgb>(skin.triangles.size(), colour)),
        true);
    m_viewpoint.restore();
    redraw();
}

void SolidCanvas::showRefused(VolumePicture picture, const Vec3& direction) {
    const bool isNew = m_viewpoint.begin();
    m_toFit = false;
    setPicture(std::move(picture), false);
    if (isNew) m_viewpoint.lookAlong(direction);
    redraw();
}

void SolidCanvas::takeView(const SolidCanvas& other) {
    m_viewpoint.setFitted(other.m_viewpoint.isFitted());
    camera() = other.camera();
    m_cutTool.setPlane(other.solid().plane());
    setCut(other.solid().cut(), other.solid().plane());
    redraw();
}

void SolidCanvas::resizeEvent(QResizeEvent* event) {
    VolumeView::resizeEvent(event);
    m_overlay->setGeometry(rect());
    if (m_viewpoint.isFitted() && !m_held) fit();
}

/// Returns the points to fit the view to, with pins and paths.
Points3 SolidCanvas::fitted() const {
    const Points3 drawn = VolumeView::fitted();
    if (m_viewport.looks().hidden || !m_session.motion().frame<3>()) return drawn;
    const std::vector<Vec3> marked = pathPoints(m_session);
    Points3 all(3, drawn.cols() + static_cast<Eigen::Index>(marked.size()));
    all.leftCols(drawn.cols()) = drawn;
    Eigen::Index next = drawn.cols();
    for (const Vec3& p : marked) all.col(next++) = p;
    return all;
}

void SolidCanvas::setFaults(const std::shared_ptr<const PoseFaults<3>>& faults) {
    if (m_look.setFaults(faults) && m_viewport.looks().map) showLooks();
}

void SolidCanvas::showCell(int cell) {
    const auto frame = m_session.motion().frame<3>();
    if (!frame || cell < 0 || cell >= frame->cells) return;
    m_overlay->markCell(cell, frame->shape);
    Points3 around(3, 4);
    for (int k = 0; k < 4; ++k) around.col(k) = frame->pose.col(frame->rest->cells[cell][k]);
    const Vec3 centre = around.rowwise().mean();
    const double wanted = kNear * frame->diagonal,
                 is = (around.colwise() - centre).colwise().norm().maxCoeff();
    m_viewpoint.zoomTo(((around.colwise() - centre) * std::max(1.0, wanted / is)).colwise() + centre);
}

void SolidCanvas::showPlace(const Vec3& at) {
    Camera next = camera();
    next.lookAt(at);
    setCamera(next);
}

// --- The cut ---

void SolidCanvas::setCutKind(CutKind kind) {
    if (kind == solid().cut() || (kind != CutKind::None && !m_session.motion().frame<3>())) {
        emit cutChanged();
        return;
    }
    if (solid().cut() == CutKind::None) m_cutTool.placeInMiddle();
    m_cutTool.setActive(kind != CutKind::None);
    setCut(kind, m_cutTool.plane());
    showLooks();
    emit cutChanged();
}

void SolidCanvas::setCutPlane(const CutPlane& plane) {
    m_cutTool.choosePlane(plane);
    setCut(solid().cut(), plane);
    showLooks();
    emit cutChanged();
}

// --- Navigation ---

void SolidCanvas::navigate(QMouseEvent& event, bool pans) {
    if (pans)
        navigation().pressToPan(event);
    else if (event.type() == QEvent::MouseMove)
        m_viewpoint.setFitted(false), VolumeView::mouseMoveEvent(&event);
    else if (event.type() == QEvent::MouseButtonRelease)
        VolumeView::mouseReleaseEvent(&event);
    else
        VolumeView::mousePressEvent(&event);
}

QString SolidCanvas::pointerText(const QPointF& at) {
    const bool busy =
        navigation().isGoingOn() || m_session.motion().isDragging() || !m_session.motion().frame<3>();
    const SolidHit hit = busy ? SolidHit{} : pick(at);
    if (!busy) emit pointedAt(hit.cell, hit.vertex, hit.point);
    if (hit.cell < 0) return {};
    const QLocale locale;
    const double minimum = 1e-9 * m_session.motion().frame()->diagonal;
    const auto number = [&](double x) { return locale.toString(std::abs(x) < minimum ? 0.0 : x, 'g', 4); };
    QString text =
        QStringLiteral("%1, %2, %3").arg(number(hit.point.x()), number(hit.point.y()), number(hit.point.z()));
    text = tr("Cell %1").arg(hit.cell) + QStringLiteral("   ") + text;
    if (!m_viewport.looks().map) return text;
    const Measure measure = m_viewport.looks().colours.measure;
    const double value = shownValues(m_session.motion(), measure)[hit.cell];
    return measureName(measure, 3) + ' ' + measureText(measure, value) + QStringLiteral("   ") + text;
}

void SolidCanvas::wheelEvent(QWheelEvent* event) {
    m_viewpoint.setFitted(false);
    VolumeView::wheelEvent(event);
}

// --- The interface of a solid's view for tools ---

QPointF SolidCanvas::onScreen(const Vec3& p) const {
    const Vec3 screen = camera().project(p, size());
    return {screen.x(), screen.y()};
}

std::vector<int> SolidCanvas::verticesWhere(const std::function<bool(const QPointF&)>& inside,
                                            bool visibleOnly) const {
    return showsFrame() ? VolumeView::verticesWhere(inside, visibleOnly) : std::vector<int>();
}

/// Returns whether the frame is shown, rather than a file's surface or an earlier mesh with other cells and
/// vertices.
bool SolidCanvas::showsFrame() const {
    const auto frame = m_session.motion().frame<3>();
    return frame && solid().picture().rest == frame->rest;
}

SolidHit SolidCanvas::pick(const QPointF& widget) const {
    return showsFrame() ? VolumeView::pick(widget) : SolidHit{};
}

std::optional<Touch> SolidCanvas::touch(const QPointF& widget) const {
    const SolidHit hit = pick(widget);
    if (hit.cell < 0) return {};
    Place place = m_session.motion().frame()->placeIn(hit.cell, hit.point);
    // A surface may reach out of the solid that takes it along.
    place.weights = place.weights.cwiseMax(0);
    place.weights /= place.weights.sum();
    return Touch{place, hit.point};
}

void SolidCanvas::showMaterial(const FramePtr& painted, bool lasts) {
    m_preview.set(m_session.motion().frame<3>(), posed<3>(painted), lasts);
    showLooks();
}

/// Whole cells reach beyond the plane: points on the drawn surface are not cut off.
bool SolidCanvas::isHidden(const Place&, const Vec3& p) const {
    const Ray sight = ray(onScreen(p));
    const SolidHit hit = solid().hit(sight);
    const double within = 2 * pixelSize(p);
    const double before = hit.cell < 0
                              ? -std::numeric_limits<double>::infinity()
                              : (p - sight.origin).dot(sight.direction) - (hit.point - sight.origin).norm();
    return before > within || (isCutOff(p) && before < -within);
}

/// Asks through its middle and those of its sides.
std::optional<Vec3> SolidCanvas::placeOf(const ShapeFrame&, int cell) const {
    if (!showsFrame()) return {};
    const Points3& pose = solid().picture().pose;
    const Cell<3>& corners = solid().picture().rest->cells[cell];
    Vec3 sum = Vec3::Zero();
    for (const int v : corners) sum += pose.col(v);
    std::vector<Vec3> middles = {sum / 4};
    for (const int v : corners) middles.push_back((sum - pose.col(v)) / 3);
    for (const Vec3& middle : middles) {
        const SolidHit hit = solid().hit(ray(onScreen(middle)));
        if (hit.cell == cell) return hit.point;
    }
    return {};
}

FramePtr SolidCanvas::shownFrame() const {
    return m_preview.over(m_session.motion().frame<3>());
}

std::vector<VertexMark> SolidCanvas::marksOf(const std::vector<int>& vertices) const {
    const Points3& pose = solid().picture().pose;
    const bool asks = vertices.size() <= kMostRays;
    std::vector<VertexMark> marks;
    for (const int v : vertices) {
        if (v >= pose.cols()) continue;
        const Vec3 at = solid().placeOf(v);
        if (!isCutOff(at) && !isCutOff(pose.col(v))) marks.push_back({at, asks && isHidden({}, pose.col(v))});
    }
    return marks;
}

}  // namespace wend
