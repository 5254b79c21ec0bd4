#include "app/views/canvas/canvas.h"

#include <QLocale>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "app/base/in_background.h"
#include "app/engine/shape/shape.h"
#include "app/project/domain.h"
#include "app/style/smooth_map.h"
#include "app/tools/picture_marks.h"
#include "app/views/shape/shape_painter.h"
#include "core/energy/distortion.h"

namespace wend {

namespace {

constexpr double kFitMargin = 36;
// fraction of the shape's size within which a visible point is the place itself
constexpr double kSamePlace = 1e-3;
constexpr int kRefineAfter = 140;  // milliseconds
constexpr int kRefineInDrag = 250;
constexpr int kMarksEvery = 20;       // without a frame
constexpr double kSeenBeyond = 0.01;  // of the picture

/// Returns a picture at rest as two triangles.
PosedPtr<2> unbent(const Image& picture) {
    auto rest = std::make_shared<SimplicialMesh<2>>();
    rest->points.resize(2, 4);
    const double w = picture.width, h = picture.height;
    rest->points << 0, w, w, 0, 0, 0, h, h;
    rest->cells = {{0, 1, 2}, {0, 2, 3}};
    auto frame = std::make_shared<PosedFrame<2>>();
    frame->dimension = 2;
    frame->rest = rest;
    frame->pose = rest->points;
    frame->distortion = std::make_shared<const Distortion>(distortion<2>(*rest, rest->points));
    return frame;
}

QRectF boxOf(const Points<2>& points) {
    const Vec<2> low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
    return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

}  // namespace

ShapeCanvas::ShapeCanvas(ShapeSession& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_viewport(*this, *this, *this, *this) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(320, 240);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Canvas"));
    setAccessibleDescription(tr("The picture with its pins"));
    m_refine.setSingleShot(true);
    connect(&m_refine, &QTimer::timeout, this, [this] {
        if (pictureOf(drawnFrame()) || !m_session.document().picture()) m_renderer.post(request(Filter::Ewa));
    });
    connect(&m_renderer, &RenderThread::rendered, this, &ShapeCanvas::takeRendered);
    connect(&m_session.document(), &Document::opened, this, &ShapeCanvas::takeOpened);
    connect(&m_session.motion(), &ShapeMotion::frameChanged, this, &ShapeCanvas::takeFrame);
    connect(&m_session.gestures(), &ShapeGesture::pinsChanged, this, &ShapeCanvas::redraw);
    connect(&m_session.document(), &Document::projectChanged, this, [this] { m_preview.takeProject(); });
}

/// Returns whether parts outside the outline are shown, too.
bool ShapeCanvas::showsPicture() const {
    return m_viewport.tool() && m_viewport.tool()->showsPicture() && !m_viewport.looks().hidden;
}

bool ShapeCanvas::isSettled() const {
    return m_drawn && !m_refine.isActive() && m_drawn->request.filter == Filter::Ewa &&
           m_session.motion().frame() && m_drawn->request.frame == drawnFrame() &&
           m_drawn->request.view == m_view && m_drawn->request.plan == plan() &&
           (m_drawn->request.allOfPicture == showsPicture() || !m_session.document().domain().parts.empty());
}

/// Returns which cells belong to hidden or locked parts; nothing if there are none.
std::vector<bool> ShapeCanvas::untouchable(const SimplicialMesh<2>& rest) const {
    const std::vector<PicturePart>& parts = m_session.document().domain().parts;
    std::vector<bool> cells;
    for (const MeshPart& range : rest.parts) {
        const auto part = std::ranges::find(parts, range.name, &PicturePart::name);
        if (part == parts.end() || !(part->hidden || part->locked)) continue;
        cells.resize(rest.cells.size());
        std::fill(cells.begin() + range.firstCell, cells.begin() + range.endCell, true);
    }
    return cells;
}

/// Returns the visible one of overlapping cells.
std::optional<Touch> ShapeCanvas::touch(const QPointF& widget) const {
    const auto frame = m_session.motion().frame<2>();
    if (!frame) return {};
    const Vec<2> p = toShape(widget);
    const std::vector<float>& depth = *depths();
    const std::vector<bool> closed = untouchable(*frame->rest);
    std::optional<Touch> best;
    for (int c = 0; c < frame->rest->cellCount(); ++c) {
        if (!closed.empty() && closed[static_cast<std::size_t>(c)]) continue;
        const Cell<2>& cell = frame->rest->cells[static_cast<std::size_t>(c)];
        const Vec<2> a = frame->pose.col(cell[0]), u = frame->pose.col(cell[1]) - a,
                     v = frame->pose.col(cell[2]) - a, w = p - a;
        const double area = u.x() * v.y() - u.y() * v.x();
        const Vec<2> by((w.x() * v.y() - w.y() * v.x()) / area, (u.x() * w.y() - u.y() * w.x()) / area);
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

std::vector<VertexMark> ShapeCanvas::marksOf(const std::vector<int>& vertices) const {
    const FramePtr frame = m_session.motion().frame();
    std::vector<VertexMark> marks;
    for (const int v : vertices)
        if (frame && v < frame->vertices) marks.push_back({frame->vertex(v), false});
    return marks;
}

void ShapeCanvas::showMaterial(const FramePtr& painted, bool lasts) {
    m_preview.set(m_session.motion().frame<2>(), posed<2>(painted), lasts);
    render();
}

void ShapeCanvas::takeOpened() {
    m_refine.stop();  // it would draw the new document without its picture
    m_picture.reset();
    m_flat.reset();
    m_unbent.reset();
    m_source.reset();
    m_pictureOf.reset();
    m_drawn.reset();
    const auto& picture = m_session.document().picture();
    m_view.setPointsUp(!picture);
    fitTo(Fitted::Picture);
    update();
    if (!picture) return;
    m_unbent = unbent(*picture);
    preparePicture(picture);
}

void ShapeCanvas::preparePicture(const std::shared_ptr<const Image>& picture) {
    m_source = picture;
    const auto prepare = [picture] { return std::make_shared<const ScreenPicture>(picture); };
    inBackground(this, prepare, [this, picture](const std::shared_ptr<const ScreenPicture>& prepared) {
        if (picture == m_session.document().picture()) m_flat = prepared;
        if (m_source != picture) return;
        m_picture = prepared;
        m_pictureOf = picture;
        emit this->prepared();
        render();
    });
}

/// A mesh may bring its picture; y points down if its coordinates are pixels.
void ShapeCanvas::takeTexture(const PosedFrame<2>& frame) {
    const auto& texture = frame.built->texture;
    if (!texture || frame.built->picture == m_source) return;
    const Mat<2>& A = texture->toPixels.A;
    m_view.setPointsUp(A(0, 0) * A(1, 1) < A(0, 1) * A(1, 0));
    preparePicture(frame.built->picture);
}

/// The parts of a picture are drawn from their atlas, and from the document's picture without a mesh.
void ShapeCanvas::takeParts(const PosedFrame<2>& frame) {
    if (!m_session.document().picture() || !frame.built) return;
    const auto& texture = frame.built->texture;
    const auto& wanted = texture && texture->drawn ? frame.built->picture : m_session.document().picture();
    if (wanted != m_source) preparePicture(wanted);
}

/// Returns the picture of a frame; null without one, or while it is prepared.
std::shared_ptr<const ScreenPicture> ShapeCanvas::pictureOf(const PosedPtr<2>& frame) const {
    if (!frame || frame == m_unbent || !frame->built) return frame == m_unbent ? m_flat : m_picture;
    const bool hasParts = frame->built->texture && frame->built->texture->drawn;
    if (!hasParts) return m_session.document().picture() ? m_flat : m_picture;
    return m_pictureOf == frame->built->picture ? m_picture : nullptr;
}

PosedPtr<2> ShapeCanvas::drawnFrame() const {
    const PosedPtr<2> own = posed<2>(shownFrame());  // a picture itself is seen before its mesh is there
    const PosedPtr<2> frame = own ? posed<2>(seen(m_viewport.looks(), own)) : nullptr;
    return frame ? frame : m_unbent;
}

/// Returns the depths of the drawn frame; null before the first mesh.
CellDepths::Values ShapeCanvas::depths() const {
    const auto frame = m_session.motion().frame<2>();
    if (!frame) return nullptr;
    const FramePtr& standIn = m_viewport.looks().standIn;
    const auto seen = standIn ? posed<2>(standIn) : frame;
    const auto mesh = seen->built ? drawnRest(*seen->built) : seen->rest;
    const Document& document = m_session.document();
    return m_depths.of(document.depth(), mesh, partLevels(document.domain().parts, *mesh, seen->time));
}

/// Returns the plan of the mesh without attached parts.
std::shared_ptr<const PaintingPlan> ShapeCanvas::cellPlan() const {
    const auto frame = drawnFrame();
    if (!depths() || !frame || !frame->built ||
        drawnRest(*frame->built)->cellCount() == frame->rest->cellCount())
        return plan();
    const Document& document = m_session.document();
    m_cellDepths.of(document.depth(), frame->rest,
                    partLevels(document.domain().parts, *frame->rest, frame->time));
    return m_cellDepths.plan();
}

std::shared_ptr<const PaintingPlan> ShapeCanvas::plan() const {
    return depths() ? m_depths.plan() : nullptr;
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

void ShapeCanvas::takeFrame() {
    const auto frame = m_session.motion().frame<2>();
    const bool first = !m_drawn && !m_session.document().picture() && frame;
    if (first) takeTexture(*frame);
    if (frame) takeParts(*frame);
    m_viewport.takeFrame();
    if (first) fitTo(Fitted::Picture);
    render();
}

RenderRequest ShapeCanvas::request(Filter filter) const {
    const Looks& looks = m_viewport.looks();
    RenderRequest request;
    request.document = m_session.document().generation();
    request.frame = drawnFrame();
    request.picture = pictureOf(request.frame);
    if (request.frame && request.frame->built) request.texture = request.frame->built->texture;
    request.plan = plan();
    request.cellPlan = cellPlan();
    request.allOfPicture = showsPicture() && !(request.texture && request.texture->drawn);
    request.view = m_view;
    request.size = size();
    request.ratio = devicePixelRatioF();
    request.filter = filter;
    const double pixels = request.ratio * request.ratio * width() * height();
    if (filter == Filter::Bilinear) request.coarseness = m_pace.coarseness(pixels);
    const auto& document = m_session.document();
    request.cutOut = !document.isEmpty() && document.domain().outline == OutlineKind::Alpha;
    const bool isShape = request.frame != m_unbent;
    request.mesh = isShape && (looks.mesh || !m_picture) && !looks.hidden;
    request.map = isShape && m_viewport.showsMap();
    request.measure = looks.colours.measure;
    request.range = looks.colours.range;
    request.opacity = looks.colours.opacity;
    request.smooth = looks.colours.smooth;
    if (request.map) request.plain = plainValue(m_session.motion(), request.measure);
    if (request.map) request.velocity = fieldOf(m_session.motion(), request.measure);
    const Theme theme = Theme::of(palette());
    request.fill = theme.dark ? QColor(0x5b6070) : QColor(0xbfc6dd);
    request.ground = !m_picture                 ? theme.workspace
                     : looks.backdrop.isValid() ? looks.backdrop
                                                : theme.checkerA;
    request.line = QColor(24, 28, 44);
    return request;
}

QImage ShapeCanvas::smallView(const QSize& size) const {
    const auto small = smallRequest(m_session.motion().frame<2>(), size);
    return small && m_picture ? RenderThread::render(*small) : QImage();
}

std::optional<RenderRequest> ShapeCanvas::smallRequest(const PosedPtr<2>& frame, const QSize& size) const {
    if (!frame || !m_session.motion().frame() || m_viewport.looks().standIn) return {};  // owner of the plan
    RenderRequest small = request(Filter::Ewa);
    small.frame = frame;
    small.mesh = small.map = small.allOfPicture = false;
    small.ratio = 1;
    small.size = size;
    small.view.fit(boxOf(frame->pose), size, 0);
    return small;
}

void ShapeCanvas::render() {
    m_viewport.showLegendLock();
    if (drawnFrame() && (pictureOf(drawnFrame()) || !m_session.document().picture())) {
        m_renderer.post(request(Filter::Bilinear));
        m_refine.start(m_session.motion().isDragging() ? kRefineInDrag : kRefineAfter);
    }
    redraw();
}

void ShapeCanvas::redraw() {
    m_viewport.redraw(kMarksEvery);
}

void ShapeCanvas::takeRendered(const std::shared_ptr<const RenderResult>& result) {
    const bool isOld = result->request.document != m_session.document().generation();
    if (isOld || !drawnFrame() || result->request.picture != pictureOf(drawnFrame())) return;
    m_drawn = result;
    if (result->request.filter == Filter::Bilinear)
        m_pace.learn(double(result->image.width()) * result->image.height(), result->milliseconds);
    update();
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
    render();
    emit viewChanged();
}

void ShapeCanvas::zoomTo(double zoom) {
    m_fitted = Fitted::No;
    m_view.setZoom(zoom, rect().center());
    showView();
}

void ShapeCanvas::zoomBy(double factor) {
    zoomTo(m_view.zoom() * factor);
}

void ShapeCanvas::showWorst() {
    const auto frame = m_session.motion().frame<2>();
    const int cell = frame ? worstOf(*frame->distortion, m_viewport.looks().colours.measure).cell : -1;
    if (cell >= 0) showPlace(inPlane(frame->centreOf(cell)));
}

void ShapeCanvas::showPlace(const Vec<2>& at) {
    m_fitted = Fitted::No;
    m_view.pan(QPointF(rect().center()) - m_view.toWidget(at));
    showView();
}

void ShapeCanvas::setFaults(const std::shared_ptr<const PoseFaults<2>>& faults) {
    m_faults = faults;
    if (m_viewport.looks().map) update();
}

void ShapeCanvas::takeView(const ShapeCanvas& other) {
    m_fitted = other.m_fitted;
    if (std::exchange(m_view, other.m_view) != other.m_view) render();
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
    const Vec<2> p = toShape(at);
    return QStringLiteral("%1, %2").arg(locale.toString(p.x(), 'f', 1), locale.toString(p.y(), 'f', 1));
}

void ShapeCanvas::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    if (steps == 0) return;
    m_fitted = Fitted::No;
    m_view.setZoom(m_view.zoom() * std::pow(1.2, steps), event->position());
    showView();
    event->accept();
}

void ShapeCanvas::resizeEvent(QResizeEvent*) {
    const bool fits = m_fitted != Fitted::No && !m_follows && !frameRect().isEmpty();
    fits ? fitView() : render();
}

// --- Drawing ---

void ShapeCanvas::paintShape(QPainter& painter) {
    if (!m_drawn) return;
    // Until the new view is drawn, shows the last one, moved and scaled.
    const RenderRequest& request = m_drawn->request;
    const double scale = m_view.zoom() / request.view.zoom();
    const QPointF origin = m_view.toWidget(request.view.toShape({0, 0}));
    painter.save();
    painter.setOpacity(m_viewport.isDimmed() ? 0.55 : 1);
    const QRectF target(origin, QSizeF(m_drawn->image.size()) / request.scale() * scale);
    const bool fits = request.view == m_view && request.coarseness == 1;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !fits);
    if (fits) {
        painter.drawImage(QPointF(0, 0), m_drawn->image);
    } else {  // Qt does not enlarge an image of fewer pixels than the screen's by its ratio
        painter.drawImage(target, m_drawn->image);
    }
    painter.restore();
}

/// Pins are hidden during playback.
void ShapeCanvas::paintOver(QPainter& painter) {
    const auto frame = m_session.motion().frame<2>();
    const Looks& looks = m_viewport.looks();
    if (looks.hidden || !frame) return;
    const Theme theme = Theme::of(palette());
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
    if (!m_session.playback().isPlaying()) {
        if (looks.groups) over.groups(*looks.groups);
        over.paths(m_viewport.hovered());
        over.pins(m_viewport.hovered(), m_viewport.named());
        if (Tool* tool = m_viewport.tool()) tool->paint(painter);
    }
    m_viewport.paintLegend(painter, size());
}

void ShapeCanvas::paintEvent(QPaintEvent*) {
    m_viewport.marksPainted();
    QPainter painter(this);
    const Looks& looks = m_viewport.looks();
    const Theme theme = Theme::of(palette());
    Ground::Look look{m_view, size(), devicePixelRatioF(), {}, looks.backdrop, theme.dark};
    if (m_session.document().picture()) look.paper = frameRect();
    m_ground.paint(painter, look, theme, m_session.motion().isDragging() || m_session.playback().isPlaying());
    m_onion.setShown(looks.onionSkin);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!looks.hidden) m_onion.paintFills(painter, *this);
    const auto frame = drawnFrame();
    const bool isMapped = frame && frame != m_unbent && m_viewport.showsMap();
    if (theme.dark && isMapped && !isPainted(looks.colours.measure))
        m_onion.paintRim(painter, *this, *frame);  // the dark end of a map is as dark as the ground
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintShape(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOver(painter);
}

}  // namespace wend
