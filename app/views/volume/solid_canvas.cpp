#include "app/views/volume/solid_canvas.h"

#include <QLocale>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

#include "app/engine/shape/shape.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/session/pins/pin_shapes.h"
#include "app/style/colours.h"
#include "app/style/smooth_map.h"
#include "app/style/theme.h"

namespace wend {

namespace {

// The colour of a cut face while no map is shown: a rose that no map uses.
constexpr QRgb kSectionColour = 0xffd6a8b8;
constexpr int kMarksEvery = 40, kMarksEveryInSoftware = 120;  // without a frame
const QRgb kPlain = qRgb(199, 186, 164), kPlainDark = qRgb(176, 164, 146);

/// The overlay of the picture, transparent to the mouse.
class Overlay : public QWidget {
  public:
    explicit Overlay(SolidCanvas& canvas) : QWidget(&canvas), m_canvas(canvas) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        m_canvas.paintOver(painter);
    }

  private:
    SolidCanvas& m_canvas;
};

/// Adds the directions of a selected curve, which may be far from it.
void addDirections(const Pin& handle, const PinPath& path, std::vector<Vec<3>>& points) {
    for (const PinMotion& motion : handle.motions) {
        const auto* curve = std::get_if<CurveMotion<3>>(&motion.kind);
        const auto at = std::lower_bound(path.times.begin(), path.times.end(), motion.start);
        if (!curve || curve->points.empty() || at == path.times.end()) continue;
        const Vec<3> start = path.points[static_cast<std::size_t>(at - path.times.begin())];
        for (const Vec<3>& p : curve->points) points.push_back(start + p - curve->points.front());
    }
}

}  // namespace

SolidCanvas::SolidCanvas(ShapeSession& session, QWidget* parent)
    : VolumeView(parent),
      m_session(session),
      m_cutTool(
          *this, [this](const CutPlane& plane) { setCutPlane(plane); },
          [this] { return m_viewport.tool() && m_viewport.tool()->hasManipulator(); }),
      m_overlay(new Overlay(*this)),
      m_viewport(*this, *this, *this, *m_overlay, &m_cutTool) {
    setMinimumSize(320, 240);
    applyTheme();
    connect(&m_session.motion(), &ShapeMotion::frameChanged, this, &SolidCanvas::takeFrame);
    connect(&m_session.gestures(), &ShapeGesture::pinsChanged, this, &SolidCanvas::redraw);
    connect(&m_session.document(), &Document::projectChanged, this, [this] {
        m_preview.takeProject();
        takeUpAxis();
    });
    connect(&m_session.document(), &Document::viewWanted, this, &SolidCanvas::keepCamera);
    connect(this, &VolumeView::cameraChanged, this, &SolidCanvas::redraw);
    takeFrame();
}

void SolidCanvas::applyTheme() {
    const Theme theme = Theme::of(palette());
    const Looks& looks = m_viewport.looks();
    m_style.edges = looks.mesh;
    m_style.flat = looks.flat;
    setBackground(ground());
    m_style.edgeColour = theme.dark ? QColor(12, 13, 18) : QColor(20, 24, 32);
    setStyle(m_style);
}

QColor SolidCanvas::ground() const {
    const QColor& backdrop = m_viewport.looks().backdrop;
    return backdrop.isValid() ? backdrop : Theme::of(palette()).workspace;
}

void SolidCanvas::showLooks() {
    applyTheme();
    refresh();
    update();
}

/// Repainting composes the whole window, which is slow without a GPU.
void SolidCanvas::redraw() {
    m_viewport.redraw(solid().isSoftware() ? kMarksEveryInSoftware : kMarksEvery);
}

/// Cancels gestures with cells and vertices of an old mesh.
void SolidCanvas::takeFrame() {
    const auto frame = m_session.motion().frame<3>();
    const std::shared_ptr<const void> mesh = frame ? frame->shape : nullptr;
    if (std::exchange(m_mesh, mesh) != mesh) m_viewport.cancelGesture();
    m_viewport.takeFrame();
    refresh();
}

QRgb SolidCanvas::plainColour() const {
    const QRgb plain = Theme::of(palette()).dark ? kPlainDark : kPlain;
    return m_viewport.isDimmed() ? dimmed(plain) : plain;
}

bool SolidCanvas::hasDetail(const PosedFrame<3>& frame) const {
    const auto& skin = frame.built->skin;
    return skin && frame.built->embedding &&
           (frame.built->cage || !m_session.document().domain().detail.empty() || hasOwnColours(*skin));
}

bool SolidCanvas::hasDetail() const {
    const auto frame = m_session.motion().frame<3>();
    return frame && hasDetail(*frame);
}

VolumePicture SolidCanvas::plainPicture(const PosedFrame<3>& frame) const {
    VolumePicture picture;
    picture.rest = frame.rest;
    picture.facets = frame.built->facets;
    picture.pose = frame.pose;
    picture.cellColours.assign(frame.rest->cells.size(), plainColour());
    picture.section = kSectionColour;
    picture.materials = m_viewport.looks().detail && hasDetail(frame);
    if (!picture.materials) return picture;
    picture.skin = frame.built->skin;
    picture.embedding = frame.built->embedding;
    return picture;
}

SurfaceStyle SolidCanvas::plainStyle() const {
    SurfaceStyle style = m_style;
    style.edges = false;
    style.dimming = style.mapOpacity = 0;
    style.rim = QColor();
    return style;
}

/// Returns true once per document, whose view is then initialized.
bool SolidCanvas::meetsNewDocument() {
    const int generation = m_session.document().generation();
    if (std::exchange(m_generation, generation) == generation) return false;
    m_planeChosen = false;
    m_fitted = true;
    return true;
}

/// Fits the view to a new solid: first at rest, then again when its motion is known.
void SolidCanvas::refresh() {
    const Looks& looks = m_viewport.looks();
    const auto frame = posed<3>(seen(looks, shownFrame()));
    m_missed = m_held;
    m_viewport.showLegendLock();
    if (!frame) setGlyphs({});  // those of the last solid
    if (!frame || m_held) return;
    VolumePicture picture = plainPicture(*frame);
    if (m_viewport.showsMap()) addMap(picture, *frame);
    m_style.dimming = m_viewport.isDimmed() && picture.materials ? 0.5 : 0;
    const bool hasMap = m_viewport.showsMap() && !isPainted(looks.colours.measure);
    m_style.mapOpacity = hasMap && picture.materials ? looks.colours.opacity : 0;
    m_style.rim = hasMap && isOnDark() ? QColor::fromRgba(kRim) : QColor();
    setStyle(m_style);
    const bool isNew = meetsNewDocument();
    if (isNew) {
        m_toFit = true;
        lookAtFirst();
    }
    if (frame->live || m_session.playback().isPlaying()) hurry();
    setPicture(std::move(picture), m_toFit && m_fitted);
    if (isNew) takeKeptCamera();
    m_toFit = m_toFit && m_session.motion().isStale();
    showGlyphs(*frame);
    m_overlay->update();  // with the solid: the window is put together once
}

bool SolidCanvas::isMoving() const {
    return VolumeView::isMoving() || m_session.motion().isDragging() || m_session.playback().isPlaying();
}

void SolidCanvas::setHeld(bool held) {
    m_held = held;
    if (!held && m_missed) refresh();
}

void SolidCanvas::showPreview(const std::shared_ptr<const Skin>& skin) {
    if (m_session.motion().frame<3>() || skin->points.cols() == 0 || !skin->points.allFinite()) return;
    const QRgb plain = Theme::of(palette()).dark ? kPlainDark : kPlain;
    lookAtFirst();
    setPicture(pictureOfSurface(skin->points, skin->triangles,
                                std::vector<QRgb>(skin->triangles.size(), dimmed(plain))),
               true);
    takeKeptCamera();
    redraw();
}

void SolidCanvas::showRefused(VolumePicture picture, const Vec<3>& direction) {
    const bool isNew = meetsNewDocument();
    if (isNew) lookAtFirst();
    m_toFit = false;
    setPicture(std::move(picture), false);
    if (isNew) lookAlong(direction);
    redraw();
}

void SolidCanvas::setDetailRegions(const std::vector<SoftRegion>& regions) {
    m_detailRegions.setRegions(regions);
    m_overlay->update();
}

void SolidCanvas::showPlace(VolumePicture picture, const Vec<3>& direction, const Points<3>& around) {
    setPicture(std::move(picture), false);
    camera().lookAlong(direction);
    camera().fit(around, size());
    m_fitted = false;
    update();
    redraw();
}

void SolidCanvas::showSolid() {
    refresh();
    fit();
}

void SolidCanvas::lookAlong(const Vec<3>& direction) {
    camera().lookAlong(direction);
    m_fitted = true;
    fit();
}

void SolidCanvas::takeView(const SolidCanvas& other) {
    m_fitted = other.m_fitted;
    camera() = other.camera();
    m_cutTool.setPlane(other.solid().plane());
    setCut(other.solid().cut(), other.solid().plane());
    update();
    redraw();
}

void SolidCanvas::resizeEvent(QResizeEvent* event) {
    VolumeView::resizeEvent(event);
    m_overlay->setGeometry(rect());
    if (m_fitted && !m_held) fit();
}

// --- The viewpoint of a solid and its storage in the project ---

/// Returns the points to fit the view to, with pins and paths.
Points<3> SolidCanvas::fitted() const {
    const Points<3> drawn = VolumeView::fitted();
    if (m_viewport.looks().hidden || !m_session.motion().frame<3>()) return drawn;
    const std::vector<Vec<3>> marked = pathPoints();
    Points<3> all(3, drawn.cols() + static_cast<Eigen::Index>(marked.size()));
    all.leftCols(drawn.cols()) = drawn;
    for (std::size_t i = 0; i < marked.size(); ++i)
        all.col(drawn.cols() + static_cast<Eigen::Index>(i)) = marked[i];
    return all;
}

/// Sets the default view for documents without a camera.
void SolidCanvas::lookAtFirst() {
    camera().setUpAxis(m_session.document().up());
    camera().setOrthographic(false);
    look(Camera::Axis::Isometric);
}

/// Restores the camera after fitting, which sets the depth range.
void SolidCanvas::takeKeptCamera() {
    const auto& kept = m_session.document().camera();
    m_asOpened.reset();
    if (!kept) return;
    camera().restore(*kept);
    m_asOpened = camera().saved();
    m_fitted = false;
    emit cameraChanged();
}

void SolidCanvas::takeUpAxis() {
    const Document& document = m_session.document();
    if (document.dimension() != 3 || document.generation() != m_generation) return;
    const UpAxis up = document.up();
    if (up == camera().upAxis()) return;
    camera().setUpAxis(up);
    fit();
}

/// Keeps the document's camera unless the user has moved it.
void SolidCanvas::keepCamera() {
    Document& document = m_session.document();
    if (!m_session.motion().frame<3>() || document.generation() != m_generation) return;
    const SavedCamera now = camera().saved();
    if (m_asOpened == now) return;
    Camera first = camera();
    first.setOrthographic(false);
    first.look(Camera::Axis::Isometric);
    const bool isTurned = now.parallel || !first.direction().isApprox(camera().direction(), 1e-6);
    if (!m_fitted) first.fit(fitted(), size());
    document.setCamera(isTurned || (!m_fitted && first.saved() != now) ? std::optional(now) : std::nullopt);
}

// --- The cut ---

CutPlane SolidCanvas::middlePlane(const Vec<3>& normal) const {
    CutPlane plane;
    plane.normal = normal;
    const auto frame = m_session.motion().frame<3>();
    if (frame) plane.point = (frame->pose.rowwise().minCoeff() + frame->pose.rowwise().maxCoeff()) / 2;
    return plane;
}

/// Cuts away the near half: along the world axis closest to the viewing direction, or along the normal chosen
/// in this document.
Vec<3> SolidCanvas::normalToViewer() const {
    const Vec<3> way = viewDirection();
    Vec<3> normal = m_cutTool.plane().normal;
    if (!m_planeChosen) {
        int axis = 0;
        way.cwiseAbs().maxCoeff(&axis);
        normal = Vec<3>::Unit(axis);
    }
    return normal.dot(way) > 0 ? Vec<3>(-normal) : normal;
}

void SolidCanvas::setCutKind(CutKind kind) {
    if (kind == solid().cut() || (kind != CutKind::None && !m_session.motion().frame<3>())) {
        emit cutChanged();
        return;
    }
    if (solid().cut() == CutKind::None) m_cutTool.setPlane(middlePlane(normalToViewer()));
    m_cutTool.setActive(kind != CutKind::None);
    setCut(kind, m_cutTool.plane());
    refresh();
    emit cutChanged();
}

void SolidCanvas::setCutPlane(const CutPlane& plane) {
    m_planeChosen = true;
    m_cutTool.setPlane(plane);
    setCut(solid().cut(), plane);
    refresh();
    emit cutChanged();
}

// --- Navigation and picking in a solid ---

void SolidCanvas::navigate(QMouseEvent& event, bool pans) {
    if (pans)
        navigation().pressToPan(event);
    else if (event.type() == QEvent::MouseMove)
        m_fitted = false, VolumeView::mouseMoveEvent(&event);
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
    m_fitted = false;
    VolumeView::wheelEvent(event);
}

/// Returns the points of the pins and their paths as they are drawn.
std::vector<Vec<3>> SolidCanvas::pathPoints() const {
    std::vector<Vec<3>> points;
    for (const PinView& view : m_session.gestures().pins()) points.push_back(view.centre);
    const auto& handles = m_session.document().design().handles;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h) {
        const auto starts = m_session.pins().pathStarts(h);
        if (handles[h].motions.empty() || starts.empty() || handles[h].traits.hidden) continue;
        for (const PinPath& path : pinPaths(handles[h], shownStarts(starts), 3)) {
            points.insert(points.end(), path.points.begin(), path.points.end());
            if (m_session.selection().contains(h)) addDirections(handles[h], path, points);
        }
    }
    return points;
}

}  // namespace wend
